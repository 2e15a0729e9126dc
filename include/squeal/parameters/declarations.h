// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_parameters_declarations_h
#define squeal_parameters_declarations_h

#include <squeal/parameters/parameters.h>
#include <squeal/parameters/schema.h>

#include <string>
#include <vector>

namespace squeal
{
  namespace prm
  {
    /**
     * Sections that exist once for each name in a list: "Scene/Bodies = a, b"
     * declares "Scene/Body a" and "Scene/Body b".
     */
    struct SectionFamily
    {
      std::string parent; /**< "Scene" */
      std::string list;   /**< "Bodies" */
      std::string word;   /**< "Body" */
      std::string documentation;

      /** "Scene/Bodies" */
      std::string list_path() const;

      /** "Scene/Body name" */
      std::string section(const std::string &name) const;
    };

    /** The families in the order of their sections. */
    const std::vector<SectionFamily> &section_families();

    /** The family that a section belongs to, or nullptr. */
    const SectionFamily *family_of(const std::string &section);

    /** The @p path of an entry with the name of a member of a family replaced by "<name>":
     * "Scene/Body pad/Shape" becomes "Scene/Body <name>/Shape". */
    std::string generic_path(const std::string &path);

    /** Makes one struct for each name, with defaults. */
    void name_members(Parameters                     &parameters,
                      const SectionFamily            &family,
                      const std::vector<std::string> &names);

    /** Declares every entry, bound to @p parameters, whose members have been
     * named before. */
    void declare_parameters(Schema &schema, Parameters &parameters);

    /** What is written in a file, checked entry by entry and put into the
     * structs; @p file is its name. Throws InputError. */
    Parameters parse_tree(PrmTree tree, const std::string &file);

    /** Every entry with one member "<name>" of each family: for printing and
     * looking up, not for reading. */
    class GenericSchema
    {
    public:
      GenericSchema();

      const Schema &operator*() const;

      const Schema *operator->() const;

    private:
      Parameters parameters;
      Schema     schema;
    };

    /** @name Parts of declare_parameters() */
    //@{
    void declare_scene(Schema &schema, SceneParameters &scene);
    void declare_body(Schema &schema, BodyParameters &body);
    void declare_contact(Schema &schema, ContactParameters &contact);
    void declare_analysis(Schema &schema, Parameters &parameters);
    void declare_sweep(Schema &schema, SweepParameters &sweep);
    void declare_preload(Schema &schema, PreloadParameters &preload);
    void declare_transient(Schema &schema, TransientParameters &transient);
    void declare_limit_cycle(Schema &schema, LimitCycleParameters &limit_cycle);
    void declare_triggers(Schema &schema, TriggersParameters &triggers);
    void declare_response(Schema &schema, Parameters &parameters);

    /** Section "Result checks", which every program has. */
    void declare_result_checks(Schema                             &schema,
                               std::vector<ResultCheckParameters> &checks);

    /** The list entry of a family; its value names the members beforehand. */
    void declare_list(Schema &schema, const SectionFamily &family);

    /** The section of every member. */
    template <typename T>
    void
    declare_members(Schema              &schema,
                    const SectionFamily &family,
                    std::vector<T>      &members,
                    void (*declare)(Schema &, T &))
    {
      for (T &member : members)
        {
          schema.enter_section(family.word + " " + member.name,
                               family.documentation);
          declare(schema, member);
          schema.leave_section();
        }
    }

    /** The family of this list entry ("Bodies"). */
    const SectionFamily &family_named(const std::string &list);
    //@}
  } // namespace prm
} // namespace squeal

#endif
