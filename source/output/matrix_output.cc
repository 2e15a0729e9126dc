// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/output/matrix_output.h>

#include <squeal/results/matrix_market.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <ostream>

namespace squeal
{
  namespace
  {
    const std::string equation =
      "(lambda^2 M + lambda C + K) x = 0, friction in K, SI units";

    /** One operator of the scene with its coefficients and its file. */
    struct NamedPart
    {
      std::string      name, label;
      TermCoefficients coefficients;
      bool             symmetric;
    };

    /** A name for files and sections: "part_01_mass_of_disc". */
    std::string
    label_of(const std::size_t number, const std::string &name)
    {
      std::string label =
        (number < 10 ? "part_0" : "part_") + std::to_string(number) + "_";
      for (const char c : name)
        label += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
      return label;
    }

    std::string
    index_of(const std::vector<NamedPart> &parts, const unsigned int n_rows)
    {
      nlohmann::ordered_json list = nlohmann::ordered_json::array();
      for (const NamedPart &part : parts)
        list.push_back(
          {{"name", part.name},
           {"file", part.label + ".mtx"},
           {"symmetric", part.symmetric},
           {"mass", part.coefficients.mass},
           {"damping", part.coefficients.damping},
           {"stiffness", part.coefficients.stiffness.real()},
           {"stiffness_imaginary", part.coefficients.stiffness.imag()}});
      const nlohmann::ordered_json index = {{"format_version", 1},
                                            {"equation", equation},
                                            {"unknowns", n_rows},
                                            {"parts", list}};
      return index.dump(
        2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    }

    /** Whether a scene of kind `matrices` can hold the parts. */
    bool
    can_be_imported(const std::vector<NamedPart> &parts)
    {
      return std::all_of(parts.begin(), parts.end(), [](const auto &part) {
        return part.coefficients.stiffness.imag() == 0. &&
               (part.symmetric || part.coefficients.mass == 0.);
      });
    }

    void
    write_section(std::ostream      &out,
                  const std::string &label,
                  const std::string &role,
                  const double       factor)
    {
      out << "\n  subsection Matrix part " << label
          << "\n    set File   = " << label << ".mtx\n    set Role   = " << role
          << "\n    set Factor = " << shortest_text(factor) << "\n  end\n";
    }

    /** M and C as a whole, K by its parts: what the undamped, frictionless
     * problem leaves out must stay apart. */
    void
    write_scene(std::ostream                 &out,
                const std::string            &name,
                const std::vector<NamedPart> &parts)
    {
      out << "# Matrices of the scene " << name
          << " as a scene of their own, to be included.\n"
          << "# The friction coefficient is relative to that of the run.\n"
          << "subsection Scene\n  set Name = " << name << "\n"
          << "  set Kind = matrices\n  set Matrix parts = mass, damping";
      for (const NamedPart &part : parts)
        if (part.coefficients.stiffness != 0.)
          out << ", " << part.label;
      out << "\n  set Friction coefficient = 1\n";
      write_section(out, "mass", "mass", 1.);
      write_section(out, "damping", "damping", 1.);
      for (const NamedPart &part : parts)
        if (part.coefficients.stiffness != 0.)
          write_section(out,
                        part.label,
                        part.symmetric ? "stiffness" : "friction",
                        part.coefficients.stiffness.real());
      out << "end\n";
    }
  } // namespace



  void
  write_matrices(RunContext        &context,
                 const Pencil      &pencil,
                 const std::string &folder)
  {
    Timers::Section         section(context.timers, "Write: matrices");
    std::vector<MatrixTerm> mass, damping, stiffness;
    for (const auto &part : pencil.parts())
      {
        mass.push_back({part.coefficients.mass, part.matrix});
        damping.push_back({part.coefficients.damping, part.matrix});
        stiffness.push_back({part.coefficients.stiffness, part.matrix});
      }
    const auto write = [&](const std::string             &name,
                           const std::vector<MatrixTerm> &terms) {
      write_matrix_market(context.output.file(folder + "/" + name + ".mtx"),
                          context.is_root,
                          *pencil.space(),
                          terms,
                          name + " of " + equation);
    };
    write("mass", mass);
    write("damping", damping);
    write("stiffness", stiffness);
  }



  void
  write_matrix_parts(RunContext         &context,
                     const AffineSystem &system,
                     const std::string  &folder)
  {
    Timers::Section        section(context.timers, "Write: matrices");
    std::vector<NamedPart> parts;
    for (const AffineTerm &term : system.terms)
      {
        parts.push_back({term.name,
                         label_of(parts.size() + 1, term.name),
                         term.coefficients(context.parameters.scene),
                         term.matrix->is_symmetric()});
        write_matrix_market(
          context.output.file(folder + "/" + parts.back().label + ".mtx"),
          context.is_root,
          *system.space,
          {{1., term.matrix}},
          term.name);
      }
    if (!context.is_root)
      return;
    write_atomically(context.output.file(folder + "/index.json"),
                     [&](std::ostream &out) {
                       out << index_of(parts, system.space->n_global()) << '\n';
                     });
    if (!can_be_imported(parts))
      {
        context.log.info("  no " + folder +
                         "/scene.prm: a scene of kind "
                         "matrices holds neither a complex stiffness nor a "
                         "non-symmetric mass");
        return;
      }
    write_atomically(context.output.file(folder + "/scene.prm"),
                     [&](std::ostream &out) {
                       write_scene(out, context.parameters.scene.name, parts);
                     });
  }



  void
  write_eigenpairs(RunContext         &context,
                   const RowSpace     &space,
                   const ComplexPairs &pairs,
                   const std::string  &folder)
  {
    Timers::Section       section(context.timers, "Write: matrices");
    const Eigen::MatrixXd re = space.to_root(Block(pairs.right.real())),
                          im = space.to_root(Block(pairs.right.imag()));
    if (!context.is_root)
      return;
    Eigen::MatrixXcd vectors(re.rows(), re.cols());
    vectors.real() = re;
    vectors.imag() = im;
    write_matrix_market(context.output.file(folder + "/eigenvalues.mtx"),
                        Eigen::MatrixXcd(pairs.lambda),
                        "lambda in 1/s, sigma > 0 unstable");
    write_matrix_market(context.output.file(folder + "/right_vectors.mtx"),
                        vectors,
                        "x of eigenvalues.mtx, a column each");
  }
} // namespace squeal
