// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/text.h>

#include <squeal/scene/import_tables.h>
#include <squeal/scene/import_text.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

namespace squeal
{
  namespace
  {
    using import::TextFile;

    /**
     * A comma-separated table with a header line. Blank lines and lines that
     * start with # are passed over.
     */
    class Table
    {
    public:
      Table(const std::string              &name,
            const std::vector<std::string> &required,
            const std::vector<std::string> &optional)
        : file(name)
      {
        if (!next_line())
          file.fail("the header line is missing");
        const std::vector<std::string> names =
          prm::split(std::string(file.line()), ',');
        n_columns = names.size();
        for (unsigned int i = 0; i < names.size(); ++i)
          if (!column_of.emplace(names[i], i).second)
            file.fail("column " + prm::in_quotes(names[i]) + " is there twice");
        for (const std::string &column : required)
          if (!has(column))
            file.fail("column " + prm::in_quotes(column) +
                      " is missing in the header line");
        for (const std::string &column : names)
          if (!contains(required, column) && !contains(optional, column))
            file.fail("column " + prm::in_quotes(column) +
                      " is not known; there may be " +
                      prm::join(required, ", ") + ", " +
                      prm::join(optional, ", "));
      }

      bool
      has(const std::string &column) const
      {
        return column_of.count(column) > 0;
      }

      /** Moves to the next line of values. */
      bool
      next()
      {
        if (!next_line())
          {
            file.check_last_line_is_complete();
            return false;
          }
        values = prm::split(std::string(file.line()), ',');
        if (values.size() != n_columns)
          file.fail("this line has " + std::to_string(values.size()) +
                    " values, the header " + std::to_string(n_columns));
        return true;
      }

      const std::string &
      text(const std::string &column) const
      {
        return values[column_of.at(column)];
      }

      long
      integer(const std::string &column) const
      {
        return import::integer_field(file, text(column), column.c_str());
      }

      double
      real(const std::string &column) const
      {
        return import::real_field(file, text(column), column.c_str());
      }

      DofLabel
      label() const
      {
        const long component = integer("component");
        if (component < 0 || component > 1000)
          file.fail("component " + std::to_string(component) +
                    " does not exist; displacements are 1 to 3, rotations 4 "
                    "to 6");
        DofLabel result;
        result.node      = integer("node");
        result.component = static_cast<unsigned int>(component);
        return result;
      }

      long
      dof() const
      {
        const long number = integer("dof");
        if (number < 1)
          file.fail("dof " + std::to_string(number) +
                    " does not exist; they count from 1");
        return number;
      }

      TextFile file;

    private:
      std::map<std::string, unsigned int> column_of;
      std::size_t                         n_columns = 0;
      std::vector<std::string>            values;

      static bool
      contains(const std::vector<std::string> &names, const std::string &name)
      {
        return std::find(names.begin(), names.end(), name) != names.end();
      }

      bool
      next_line()
      {
        while (file.next())
          {
            const std::string_view line = import::trimmed(file.line());
            if (!line.empty() && line[0] != '#')
              return true;
          }
        return false;
      }
    };

    ContactTerm::Side
    read_side(const Table &table)
    {
      const std::string &text = table.text("side");
      if (text == "source")
        return ContactTerm::Side::source;
      if (text == "target")
        return ContactTerm::Side::target;
      table.file.fail("side " + prm::in_quotes(text) +
                      " is not known; write source or target");
    }

    ContactTerm::Direction
    read_direction(const Table &table)
    {
      const std::string &text = table.text("direction");
      if (text == "normal")
        return ContactTerm::Direction::normal;
      if (text == "sliding")
        return ContactTerm::Direction::sliding;
      if (text == "transverse")
        return ContactTerm::Direction::transverse;
      table.file.fail("direction " + prm::in_quotes(text) +
                      " is not known; write normal, sliding or transverse");
    }
  } // namespace



  std::vector<NodeTableRow>
  read_node_table(const std::string              &name,
                  const std::vector<std::string> &loads,
                  const std::vector<std::string> &contacts)
  {
    std::vector<std::string> required = {
      "node", "component", "x", "y", "z", "body"};
    for (const std::string &load : loads)
      required.push_back("load_" + load);
    std::vector<std::string> optional = {"dof"};
    for (const std::string &contact : contacts)
      optional.push_back("far_" + contact);
    Table                     table(name, required, optional);
    std::vector<NodeTableRow> rows;
    std::set<long>            dofs;
    std::set<DofLabel>        labels;
    while (table.next())
      {
        NodeTableRow row;
        row.label    = table.label();
        row.position = {{table.real("x"), table.real("y"), table.real("z")}};
        row.body     = table.text("body");
        row.line     = table.file.line_number();
        for (const std::string &load : loads)
          row.forces.push_back(table.real("load_" + load));
        for (const std::string &contact : contacts)
          row.far_weights.push_back(table.has("far_" + contact)
                                      ? table.real("far_" + contact)
                                      : std::nan(""));
        if (row.body.empty())
          table.file.fail("the body has no name");
        if (!labels.insert(row.label).second)
          table.file.fail(describe(row.label) + " is given twice");
        if (table.has("dof"))
          {
            row.dof = table.dof();
            if (!dofs.insert(row.dof).second)
              table.file.fail("dof " + std::to_string(row.dof) +
                              " is given twice");
          }
        rows.push_back(row);
      }
    if (rows.empty())
      table.file.fail("the table has no lines below its header");
    return rows;
  }



  namespace
  {
    /** What all lines of a point pair must agree on. */
    bool
    agree(const ContactTerm &a, const ContactTerm &b)
    {
      return a.stiffness_factor == b.stiffness_factor &&
             a.position == b.position && a.area == b.area &&
             a.speed_ratio == b.speed_ratio;
    }

    void
    require_positive(const Table &table, const double value, const char *what)
    {
      if (!(value > 0.))
        table.file.fail(std::string("the ") + what + " must be positive");
    }

    /** The columns of a scene that names its contacts. */
    void
    read_place(const Table &table, ContactTerm &term)
    {
      term.contact  = table.text("contact");
      term.position = {{table.real("x"), table.real("y"), table.real("z")}};
      term.area     = table.real("area");
      require_positive(table, term.area, "area");
      if (table.has("speed_ratio"))
        term.speed_ratio = table.real("speed_ratio");
      require_positive(table, term.speed_ratio, "speed ratio");
    }

    /** 1 to 3 of "held x" to "held z". */
    std::optional<unsigned int>
    held_axis(const std::string &text)
    {
      for (unsigned int c = 0; c < 3; ++c)
        if (text == std::string("held ") + "xyz"[c])
          return c + 1;
      return std::nullopt;
    }

    /** The unknown of a line: by its number, by node and component, or one that
     * supports hold. */
    void
    read_unknown(const Table &table, const bool has_labels, ContactTerm &term)
    {
      const std::string &text = table.text(has_labels ? "node" : "dof");
      const auto         axis = held_axis(text);
      term.is_held            = axis.has_value();
      if (axis)
        term.label.component = *axis;
      else if (has_labels)
        term.label = table.label();
      else
        term.dof = table.dof();
    }
  } // namespace



  std::vector<ContactTerm>
  read_contact_pattern(const std::string &name, const bool of_contacts)
  {
    std::vector<std::string> required = {"pair", "side", "direction", "weight"},
                             optional = {"dof", "node", "component"};
    if (of_contacts)
      required.insert(required.end(), {"contact", "x", "y", "z", "area"});
    optional.push_back(of_contacts ? "speed_ratio" : "stiffness_factor");
    Table      table(name, required, optional);
    const bool has_labels = table.has("node") && table.has("component");
    if (has_labels == table.has("dof"))
      table.file.fail("the header line needs either dof or node and component");

    std::vector<ContactTerm>                            terms;
    std::map<std::pair<std::string, long>, std::size_t> first;
    while (table.next())
      {
        ContactTerm term;
        term.pair      = table.integer("pair");
        term.side      = read_side(table);
        term.direction = read_direction(table);
        read_unknown(table, has_labels, term);
        term.weight = table.real("weight");
        term.line   = table.file.line_number();
        if (table.has("stiffness_factor"))
          term.stiffness_factor = table.real("stiffness_factor");
        require_positive(table, term.stiffness_factor, "stiffness factor");
        if (of_contacts)
          read_place(table, term);
        const auto [place, is_new] =
          first.emplace(std::make_pair(term.contact, term.pair), terms.size());
        if (!is_new && !agree(terms[place->second], term))
          table.file.fail(
            "pair " + std::to_string(term.pair) +
            (of_contacts ? " has two different places, areas or speed ratios"
                         : " has two different stiffness factors"));
        terms.push_back(term);
      }
    if (terms.empty())
      table.file.fail("the pattern has no lines below its header");
    return terms;
  }
} // namespace squeal
