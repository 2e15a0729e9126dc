// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_parameters_schema_h
#define squeal_parameters_schema_h

#include <squeal/parameters/allowed.h>
#include <squeal/parameters/bindings.h>
#include <squeal/parameters/prm_tree.h>

#include <functional>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

// deal.II's header costs seconds in every file that reads it
namespace dealii
{
  class ParameterHandler;
}

namespace squeal
{
  namespace prm
  {
    /**
     * The declared entries of a parameter file, each bound to the member of a
     * struct that it sets. A dealii::ParameterHandler keeps default, pattern,
     * documentation and value; the schema adds the order, what is allowed in
     * words, where a value comes from, and the binding.
     *
     * Declare with enter_section(), add() and leave_section(); then set() what
     * the file says and finally assign() everything to the structs, which must
     * still be where they were when they were added.
     */
    class Schema
    {
    public:
      struct Entry
      {
        std::string section; /**< "Section/Sub" */
        std::string name;
        std::string default_value; /**< in canonical form */
        Allowed     allowed;
        std::string documentation; /**< without the unit */
        std::string units;
        std::function<void(const std::string &)> assign;
        /** Fixed matrices are multiplied by functions of it: a sweep keeps
         * them. */
        bool is_affine = false;
        /** A coefficient of friction: steady states that differ in it alone
         * share the flexibility of the contact. */
        bool is_friction = false;
        /** How finely a run computes, not what: campaigns make ladders of it.
         */
        bool is_resolution = false;
        /** Where it is given per area, of an elastic bed or of contact springs
         * of the layout 'quadrature'; empty: nowhere. */
        std::string units_per_area = {};

        /** @name Traits, behind add() and declare() */
        //@{
        Entry &
        affine()
        {
          is_affine = true;
          return *this;
        }
        Entry &
        friction()
        {
          is_friction = true;
          return *this;
        }
        Entry &
        resolution()
        {
          is_resolution = true;
          return *this;
        }
        Entry &
        per_area(const std::string &its_units)
        {
          units_per_area = its_units;
          return *this;
        }
        //@}

        std::string path() const;
        /** "N/m, per area N/m^3" */
        std::string units_text() const;
      };

      struct Section
      {
        std::string path;
        std::string documentation;
      };

      Schema();
      ~Schema();
      Schema(const Schema &)            = delete;
      Schema &operator=(const Schema &) = delete;

      /** @name Declaring */
      //@{
      void enter_section(const std::string &name,
                         const std::string &documentation);

      void leave_section();

      /** Declares an entry whose default is the present value of @p value. */
      template <typename T>
      Entry &
      add(const std::string &name,
          T                 &value,
          const Allowed     &allowed,
          const std::string &documentation,
          const std::string &units = "none")
      {
        return declare(
          {section_path(),
           name,
           to_text(value),
           allowed,
           documentation,
           units,
           [&value](const std::string &text) { from_text(text, value); }});
      }

      /** The same for flags and enumerations, which know what is allowed. */
      template <typename T>
      void
      add(const std::string &name, T &value, const std::string &documentation)
      {
        if constexpr (std::is_same_v<T, bool>)
          add(name, value, Allowed::flag(), documentation);
        else
          add(name, value, allowed_choices(value), documentation);
      }

      /** Any of the names of an enumeration. */
      template <typename Enum>
      static Allowed
      allowed_choices(const Enum example)
      {
        std::vector<std::string> names;
        for (const auto &choice : choices(example))
          names.push_back(choice.first);
        return Allowed::one_of(names);
      }

      /** Declares an entry that is assigned in its own way; its section is the
       * present one. The reference holds until the next declaration. */
      Entry &declare(Entry entry);

      /** The section that add() declares in. */
      std::string section_path() const;
      //@}

      /** @name Values */
      //@{
      /** Takes a value for a declared entry. Throws InputError with location,
       * entry, value and what is allowed. */
      void set(const RawEntry &raw);

      /** The value in canonical form, the default if none was set. */
      std::string value(const Entry &entry) const;

      /** Hands every value to its member, in the order of declaration. */
      void assign() const;
      //@}

      /** @name Access */
      //@{
      const std::vector<Entry> &entries() const;

      /** Sections in the order of declaration, the top level first. */
      const std::vector<Section> &sections() const;

      /** The entry of this path, or nullptr. */
      const Entry *find(const std::string &path) const;

      bool has_section(const std::string &path) const;

      /** Names of the entries in a section. */
      std::vector<std::string> entries_of(const std::string &section) const;

      /** Names of the sections directly in a section. */
      std::vector<std::string> sections_of(const std::string &section) const;
      //@}

    private:
      std::unique_ptr<dealii::ParameterHandler>    handler;
      std::vector<std::string>                     open_sections;
      std::vector<Entry>                           entry_list;
      std::vector<Section>                         section_list;
      std::unordered_map<std::string, std::size_t> entry_index;
    };
  } // namespace prm
} // namespace squeal

#endif
