// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/declarations.h>
#include <squeal/parameters/parameters.h>
#include <squeal/parameters/schema_text.h>
#include <squeal/parameters/text.h>

#include <ostream>
#include <sstream>

namespace squeal
{
  namespace
  {
    /** Prints @p text in comment lines of 80 columns. */
    void
    print_comment(const std::string &text,
                  const std::string &indent,
                  std::ostream      &out)
    {
      std::istringstream words(text);
      std::string        line = indent + "#";
      for (std::string word; words >> word;)
        {
          if (line.size() + 1 + word.size() > 80 &&
              line.size() > indent.size() + 1)
            {
              out << line << '\n';
              line = indent + "#";
            }
          line += " " + word;
        }
      out << line << '\n';
    }



    /** "one of a, b" -> "One of a, b". */
    std::string
    capitalised(std::string text)
    {
      if (!text.empty() && text[0] >= 'a' && text[0] <= 'z')
        text[0] = static_cast<char>(text[0] - 'a' + 'A');
      return text;
    }



    /** A section with its entries and the sections in it; those of a family
     * are put in comments. */
    void
    print_section(const prm::Schema &schema,
                  const std::string &path,
                  const std::string &indent,
                  const std::string &mark,
                  std::ostream      &out)
    {
      for (const prm::Schema::Entry &entry : schema.entries())
        if (entry.section == path)
          {
            print_comment(entry.documentation + " " +
                            capitalised(entry.allowed.words()) +
                            ". Units: " + entry.units_text() + ".",
                          indent,
                          out);
            out << indent << mark << "set " << entry.name << " ="
                << (entry.default_value.empty() ? ""
                                                : " " + entry.default_value)
                << "\n\n";
          }
      for (const prm::Schema::Section &section : schema.sections())
        if (!section.path.empty() && prm::section_of(section.path) == path)
          {
            const bool is_member = prm::family_of(section.path) != nullptr;
            const std::string inner_mark = is_member ? "#" : mark;
            print_comment(section.documentation, indent, out);
            out << indent << inner_mark << "subsection "
                << prm::entry_of(section.path) << '\n';
            print_section(schema, section.path, indent + "  ", inner_mark, out);
            out << indent << inner_mark << "end\n\n";
          }
    }



    /** @p text as a cell of a markdown table. */
    std::string
    cell(const std::string &text)
    {
      std::string result;
      for (const char c : text)
        if (c == '|')
          result += "\\|";
        else if (c == '<')
          result += "&lt;";
        else
          result += c;
      return result;
    }



    std::string
    code(const std::string &text)
    {
      return text.empty() ? "" : "`" + text + "`";
    }
  } // namespace



  namespace prm
  {
    void
    print_defaults(const Schema &generic, std::ostream &out)
    {
      print_section(generic, "", "", "", out);
    }



    void
    print_documentation(const Schema &generic, std::ostream &out)
    {
      for (const Schema::Section &section : generic.sections())
        {
          out << "\n## "
              << (section.path.empty() ? "Top level" : code(section.path))
              << "\n\n";
          if (!section.documentation.empty())
            out << cell(section.documentation) << "\n\n";
          out << "| entry | default | allowed | meaning |\n"
                 "| --- | --- | --- | --- |\n";
          for (const Schema::Entry &entry : generic.entries())
            if (entry.section == section.path)
              out << "| " << cell(entry.name) << " | "
                  << code(entry.default_value) << " | "
                  << cell(entry.allowed.words()) << " | "
                  << cell(entry.documentation +
                          " Units: " + entry.units_text() + ".")
                  << " |\n";
        }
    }
  } // namespace prm



  void
  print_defaults(std::ostream &out)
  {
    const prm::GenericSchema generic;
    prm::print_defaults(*generic, out);
  }



  void
  print_parameter_documentation(std::ostream &out)
  {
    const prm::GenericSchema generic;
    out << "# Parameters\n\n"
           "Every entry of a parameter file. A section with `<name>` exists "
           "once for each name in its list. Numbers may be written as powers, "
           "`10^10.4`.\n";
    prm::print_documentation(*generic, out);
  }
} // namespace squeal
