// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/parameters/checks.h>
#include <squeal/parameters/declarations.h>
#include <squeal/parameters/prm_tree.h>
#include <squeal/parameters/unknown_names.h>
#include <squeal/tribology/setup/tribology_parameters.h>

#include <ostream>

namespace squeal::tribology
{
  namespace
  {
    void
    name_checks(TribologyParameters            &parameters,
                const std::vector<std::string> &names)
    {
      for (const std::string &name : names)
        {
          parameters.result_checks.emplace_back();
          parameters.result_checks.back().name = name;
        }
    }



    void
    check_parts(const TribologyParameters &p)
    {
      using A = TribologyParameters::Analysis;
      if (p.output.directory.empty())
        prm::refuse_entry("", "Output directory", "is empty: name a folder");
      if (p.analysis == A::damage)
        {
          check_history(p.history);
          check_fatigue(p.fatigue);
          check_subsurface(p.subsurface);
        }
      if (p.analysis == A::recorded_history)
        check_recorded_history(p.recorded_history);
      if (p.analysis == A::correlation)
        check_correlation(p.correlation);
      if (p.analysis == A::segmentation)
        check_segmentation(p.images, p.segmentation);
      if (p.analysis == A::synthetic_specimen)
        check_specimen(p.images, p.specimen);
      for (const ResultCheckParameters &check : p.result_checks)
        prm::check_result_check(check);
    }
  } // namespace



  void
  TribologyParameters::check() const
  {
    try
      {
        check_parts(*this);
      }
    catch (const InputError &e)
      {
        throw InputError((file.empty() ? "" : file + ": ") + e.what());
      }
  }



  TribologyParameters
  read_tribology_parameters(const std::string              &file,
                            const std::vector<std::string> &overrides)
  {
    prm::PrmTree tree = prm::read_prm_file(file);
    for (const std::string &text : overrides)
      tree.set(prm::parse_override(text));
    std::vector<std::string> others;
    for (const auto &[name, analysis] : choices(Parameters::Analysis()))
      others.push_back(name);
    prm::refuse_files_of("squeal", others, tree);

    TribologyParameters       parameters;
    const prm::SectionFamily &family = prm::family_named("Checks");
    parameters.file                  = file;
    name_checks(parameters,
                prm::listed_names(
                  tree, family.list_path(), [&family](const std::string &name) {
                    return family.section(name);
                  }));
    prm::Schema schema;
    declare_tribology(schema, parameters);
    parameters.used = prm::fill_schema(tree, schema, *GenericTribologySchema());
    return parameters;
  }



  GenericTribologySchema::GenericTribologySchema()
  {
    name_checks(parameters, {"<name>"});
    declare_tribology(schema, parameters);
  }



  void
  print_tribology_defaults(std::ostream &out)
  {
    prm::print_defaults(*GenericTribologySchema(), out);
  }



  void
  print_tribology_documentation(std::ostream &out)
  {
    out << "# Parameters of squeal-tribology\n\n"
           "Every entry of a parameter file for the analyses of damage, "
           "images and their correlation. A section with `<name>` exists once "
           "for each name in its list.\n";
    prm::print_documentation(*GenericTribologySchema(), out);
  }
} // namespace squeal::tribology
