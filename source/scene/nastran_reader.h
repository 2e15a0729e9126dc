// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_scene_nastran_reader_h
#define squeal_scene_nastran_reader_h

#include <squeal/scene/bulk_data.h>
#include <squeal/scene/mesh_file.h>

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

namespace squeal
{
  /** Reads the mesh of a Nastran bulk data file. Throws InputError with file
   * and line. */
  class NastranReader
  {
  public:
    NastranReader(const std::string &name, const std::vector<std::string> &sets)
      : text(name)
      , wanted(sets.begin(), sets.end())
    {
    }

    MeshFile read();

  private:
    /** A face of a load: an element and two opposite corners. */
    struct Load
    {
      long         element, corner, opposite;
      std::string  name;
      unsigned int line;
    };
    struct Cell
    {
      std::size_t       position; /**< in the elements of the file */
      long              property;
      std::vector<long> points;
      unsigned int      line;
    };
    struct Section
    {
      long         material;
      bool         is_fluid;
      unsigned int line;
    };

    void              go_to_bulk_data();
    void              take_case_control(const unsigned int n_lines);
    [[noreturn]] void refuse_parts(const unsigned int line) const;
    void              take(const import::BulkEntry &entry);
    void              read_point(const import::BulkEntry &entry);
    void              read_cell(const import::BulkEntry &entry);
    void              read_load(const import::BulkEntry &entry);
    void              read_property(const import::BulkEntry &entry);
    void              read_material(const import::BulkEntry &entry);
    void              add_material(const import::BulkEntry  &entry,
                                   const MeshFile::Material &material);
    void              note_constraints(const import::BulkEntry &entry);
    void              read_parameter(const import::BulkEntry &entry);
    void              finish_materials();
    void read_set(const import::BulkEntry &entry, const std::size_t first);
    void finish();
    void number_points();
    void place_hexahedron(const Cell &cell);
    void add_face_of(const Load &load);
    void add_point_sets();
    void group_cells();

    long         integer(const import::BulkEntry &entry,
                         const std::size_t        i,
                         const char              *what) const;
    long         integer_or(const import::BulkEntry &entry,
                            const std::size_t        i,
                            const long               otherwise,
                            const char              *what) const;
    double       real_or_zero(const import::BulkEntry &entry,
                              const std::size_t        i,
                              const char              *what) const;
    unsigned int point(const long number, const unsigned int line) const;

    import::TextFile                       text;
    const std::set<std::string>            wanted;
    MeshFile                               file;
    bool                                   has_bulk_begin = false;
    std::unordered_map<long, unsigned int> index_of_point;
    std::vector<Cell>                      cells;
    std::unordered_map<long, std::size_t>  cell_of_element;
    std::vector<Load>                      loads;
    std::map<long, Section>                sections;
    std::map<long, int>                    materials;
    /** Of materials that entries beside MAT1 make depend on more. */
    std::map<long, std::string> faults;
    /** Of weights as densities: PARAM,WTMASS. */
    std::optional<double>                            mass_factor;
    std::map<long, std::vector<std::array<long, 2>>> point_sets, cell_sets;
    MeshGroups                                       groups{file};
  };
} // namespace squeal

#endif
