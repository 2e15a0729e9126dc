// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_scene_abaqus_reader_h
#define squeal_scene_abaqus_reader_h

#include <squeal/scene/abaqus_part.h>
#include <squeal/scene/import_text.h>

#include <map>
#include <string>
#include <vector>

namespace squeal
{
  /** Reads the mesh of an Abaqus input file, keyword by keyword. Throws
   * InputError with file and line. */
  class AbaqusReader
  {
  public:
    AbaqusReader(const std::string              &name,
                 const std::vector<std::string> &wanted)
      : text(name)
      , wanted(wanted)
    {
    }

    MeshFile read();

  private:
    struct Keyword
    {
      std::string                        name;    /**< in capitals */
      std::map<std::string, std::string> options; /**< keys in capitals */
      unsigned int                       line = 0;
    };
    /** Nodes and elements of an instance by their numbers. */
    struct Instance
    {
      AbaqusPart::Numbers nodes, elements;
    };
    using Sets = std::map<std::string, AbaqusPart::Set>;

    bool               next_line();
    bool               next_keyword();
    void               add_options(const std::string &line);
    bool               next_data();
    const std::string *find_option(const char *key) const;
    bool               has_option(const char *key) const;
    std::string        option(const char *key) const;
    std::string        needed(const char *key) const;
    long               integer(const std::size_t i, const char *what) const;
    double             real(const std::size_t i, const char *what) const;
    std::string        data(const std::size_t i) const;

    void take();
    void begin_part();
    void end_part();
    void begin_instance();
    void end_instance();
    void read_nodes();
    void read_elements();
    void read_element(const std::string   &type,
                      const MeshFile::Kind kind,
                      const unsigned int   n_nodes,
                      AbaqusPart::Set     *set);
    void read_set(const bool of_nodes);
    void read_range(const AbaqusPart::Numbers &numbers, AbaqusPart::Set &set);
    std::vector<unsigned int> members(const std::string &entry,
                                      const bool         of_nodes,
                                      const std::string &instance) const;
    void                      read_surface();
    void                      read_place();
    void                      read_section();
    void                      resolve_sections(AbaqusPart &part) const;
    void                      read_elastic();
    void                      read_density();
    void                      read_viscoelastic();
    void                      read_tie();
    void                      read_step();
    void                      finish();

    import::TextFile                  text;
    const std::vector<std::string>    wanted;
    bool                              is_held = false; /**< line not yet used */
    Keyword                           keyword;
    std::vector<std::string>          fields;
    bool                              ends_with_comma = false;
    MeshFile                          file;
    AbaqusPart                        model, draft;
    InstancePlace                     place; /**< of the draft */
    AbaqusPart                       *current = &model;
    std::string                       open_part, open_instance;
    bool                              is_assembly_open = false;
    std::map<std::string, AbaqusPart> parts;
    std::map<std::string, Instance>   instances;
    std::map<std::string, int>        materials;
  };
} // namespace squeal

#endif
