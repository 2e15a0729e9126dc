// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/available_memory.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/hdf5_handle.h>
#include <squeal/base/number_text.h>
#include <squeal/base/open_hdf5_files.h>
#include <squeal/base/sealed_file.h>
#include <squeal/base/unknown_choice.h>
#include <squeal/results/hdf5_file.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <numeric>

namespace squeal
{
  namespace
  {
    hid_t
    type_of(const Hdf5File::Kind kind)
    {
      switch (kind)
        {
        case Hdf5File::Kind::real32:
          return H5T_IEEE_F32LE;
        case Hdf5File::Kind::integer32:
          return H5T_STD_I32LE;
        case Hdf5File::Kind::integer8:
          return H5T_STD_U8LE;
        case Hdf5File::Kind::real64:
          return H5T_IEEE_F64LE;
        }
      unknown_choice("kind of number");
    }



    std::uint64_t
    size_of(const Hdf5File::Dimensions &dimensions)
    {
      return std::accumulate(dimensions.begin(),
                             dimensions.end(),
                             std::uint64_t(1),
                             std::multiplies<>());
    }



    std::vector<hsize_t>
    sizes(const Hdf5File::Dimensions &dimensions)
    {
      return {dimensions.begin(), dimensions.end()};
    }



    Hdf5Handle
    text_type(const std::size_t length)
    {
      const hid_t type = H5Tcopy(H5T_C_S1);
      H5Tset_size(type, std::max<std::size_t>(1, length));
      return {type, H5Tclose};
    }



    /** Without the time of day: the same results have the same bytes. */
    Hdf5Handle
    dataset_creation()
    {
      const hid_t list = H5Pcreate(H5P_DATASET_CREATE);
      H5Pset_obj_track_times(list, 0);
      return {list, H5Pclose};
    }



    Hdf5Handle
    intermediate_groups()
    {
      const hid_t list = H5Pcreate(H5P_LINK_CREATE);
      H5Pset_create_intermediate_group(list, 1);
      return {list, H5Pclose};
    }
  } // namespace



  Hdf5File::Hdf5File(const std::string &path, const Mode mode)
    : file_name(path)
  {
    // failures are told by our own one line
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    if (mode == Mode::create)
      id = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    else if (mode == Mode::create_sealed)
      id =
        H5Fcreate(path.c_str(), H5F_ACC_TRUNC, sealed_creation(), H5P_DEFAULT);
    else
      {
        namespace fs = std::filesystem;
        std::error_code error;
        if (!fs::exists(path, error))
          fail("does not exist");
        if (!fs::is_regular_file(path, error))
          fail("is no file");
        const htri_t is_hdf5 = H5Fis_hdf5(path.c_str());
        id =
          is_hdf5 > 0 ? H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT) : -1;
        if (is_hdf5 > 0 && id < 0)
          fail("is a damaged or truncated HDF5 file; make it again");
        if (id < 0)
          fail("is no HDF5 file");
      }
    if (id < 0)
      fail("cannot be written");
  }



  Hdf5File::~Hdf5File()
  {
    if (id >= 0)
      close_hdf5_file(id);
  }



  void
  Hdf5File::close()
  {
    const hid_t file = id;
    id               = -1;
    if (close_hdf5_file(file) < 0)
      fail("could not be written to its end; is the disk full?");
  }



  void
  Hdf5File::fail(const std::string &what) const
  {
    throw InputError("'" + file_name + "' " + what);
  }



  const std::string &
  Hdf5File::path() const
  {
    return file_name;
  }



  void
  Hdf5File::write_attribute(const std::string &name, const double value)
  {
    const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    const Hdf5Handle attribute(
      H5Acreate2(
        id, name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose);
    if (!attribute.is_valid() ||
        H5Awrite(attribute, H5T_NATIVE_DOUBLE, &value) < 0)
      fail("cannot be written (attribute " + name + ")");
  }



  void
  Hdf5File::write_attribute(const std::string &name, const std::string &text)
  {
    const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    const Hdf5Handle type = text_type(text.size());
    const Hdf5Handle attribute(
      H5Acreate2(id, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose);
    if (!attribute.is_valid() || H5Awrite(attribute, type, text.c_str()) < 0)
      fail("cannot be written (attribute " + name + ")");
  }



  bool
  Hdf5File::has_attribute(const std::string &name) const
  {
    return H5Aexists(id, name.c_str()) > 0;
  }



  double
  Hdf5File::number_attribute(const std::string &name) const
  {
    const Hdf5Handle attribute(H5Aopen(id, name.c_str(), H5P_DEFAULT),
                               H5Aclose);
    double           value = 0.;
    if (!attribute.is_valid() ||
        H5Aread(attribute, H5T_NATIVE_DOUBLE, &value) < 0)
      fail("has no number '" + name + "'");
    return value;
  }



  std::string
  Hdf5File::text_attribute(const std::string &name) const
  {
    const Hdf5Handle attribute(H5Aopen(id, name.c_str(), H5P_DEFAULT),
                               H5Aclose);
    if (!attribute.is_valid())
      fail("has no text '" + name + "'");
    const Hdf5Handle in_file(H5Aget_type(attribute), H5Tclose);
    if (H5Tget_class(in_file) != H5T_STRING || H5Tis_variable_str(in_file) != 0)
      fail("has no text of fixed length '" + name + "'");
    std::string text(H5Tget_size(in_file), '\0');
    if (H5Aread(attribute, in_file, text.data()) < 0)
      fail("has no text '" + name + "'");
    return text.c_str();
  }



  void
  Hdf5File::write(const std::string         &name,
                  const Dimensions          &dimensions,
                  const std::vector<double> &values,
                  const Kind                 kind)
  {
    const std::vector<hsize_t> extent = sizes(dimensions);
    const Hdf5Handle           space(
      H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr),
      H5Sclose);
    const Hdf5Handle groups = intermediate_groups();
    const Hdf5Handle data(H5Dcreate2(id,
                                     name.c_str(),
                                     type_of(kind),
                                     space,
                                     groups,
                                     dataset_creation(),
                                     H5P_DEFAULT),
                          H5Dclose);
    if (!data.is_valid() || (!values.empty() && H5Dwrite(data,
                                                         H5T_NATIVE_DOUBLE,
                                                         H5S_ALL,
                                                         H5S_ALL,
                                                         H5P_DEFAULT,
                                                         values.data()) < 0))
      fail("cannot be written (dataset " + name + ")");
  }



  void
  Hdf5File::write(const std::string              &name,
                  const std::vector<std::string> &texts)
  {
    std::size_t length = 1;
    for (const std::string &text : texts)
      length = std::max(length, text.size());
    std::string block;
    for (const std::string &text : texts)
      block += text + std::string(length - text.size(), '\0');
    const hsize_t    n = texts.size();
    const Hdf5Handle space(H5Screate_simple(1, &n, nullptr), H5Sclose);
    const Hdf5Handle type   = text_type(length);
    const Hdf5Handle groups = intermediate_groups();
    const Hdf5Handle data(
      H5Dcreate2(
        id, name.c_str(), type, space, groups, dataset_creation(), H5P_DEFAULT),
      H5Dclose);
    if (!data.is_valid() ||
        (n > 0 &&
         H5Dwrite(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, block.data()) < 0))
      fail("cannot be written (dataset " + name + ")");
  }



  void
  Hdf5File::create_growing(const std::string  &name,
                           const Dimensions   &row,
                           const Kind          kind,
                           const std::uint64_t n_chunk)
  {
    std::vector<hsize_t> extent = sizes(row), most = sizes(row),
                         chunk = sizes(row);
    extent.insert(extent.begin(), 0);
    most.insert(most.begin(), H5S_UNLIMITED);
    chunk.insert(chunk.begin(), n_chunk);
    const Hdf5Handle space(H5Screate_simple(static_cast<int>(extent.size()),
                                            extent.data(),
                                            most.data()),
                           H5Sclose);
    const Hdf5Handle list = dataset_creation();
    H5Pset_chunk(list, static_cast<int>(chunk.size()), chunk.data());
    const Hdf5Handle groups = intermediate_groups();
    const Hdf5Handle data(
      H5Dcreate2(
        id, name.c_str(), type_of(kind), space, groups, list, H5P_DEFAULT),
      H5Dclose);
    if (!data.is_valid())
      fail("cannot be written (dataset " + name + ")");
  }



  void
  Hdf5File::append(const std::string &name, const std::vector<double> &values)
  {
    std::vector<hsize_t> extent = sizes(dimensions(name));
    std::vector<hsize_t> start(extent.size(), 0), count = extent;
    const std::uint64_t  row =
      size_of(Dimensions(extent.begin() + 1, extent.end()));
    start[0] = extent[0];
    count[0] = row == 0 ? 0 : values.size() / row;
    extent[0] += count[0];
    if (count[0] == 0)
      return;
    const Hdf5Handle data(H5Dopen2(id, name.c_str(), H5P_DEFAULT), H5Dclose);
    if (!data.is_valid() || H5Dset_extent(data, extent.data()) < 0)
      fail("cannot be written (dataset " + name + ")");
    const Hdf5Handle space(H5Dget_space(data), H5Sclose);
    const Hdf5Handle memory(
      H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr),
      H5Sclose);
    H5Sselect_hyperslab(
      space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
    if (H5Dwrite(
          data, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, values.data()) <
        0)
      fail("cannot be written (dataset " + name + "); is the disk full?");
  }



  bool
  Hdf5File::has(const std::string &name) const
  {
    for (std::size_t end = name.find('/'); end != std::string::npos;
         end             = name.find('/', end + 1))
      if (H5Lexists(id, name.substr(0, end).c_str(), H5P_DEFAULT) <= 0)
        return false;
    return H5Lexists(id, name.c_str(), H5P_DEFAULT) > 0;
  }



  Hdf5File::Dimensions
  Hdf5File::dimensions(const std::string &name) const
  {
    if (!has(name))
      fail("has no dataset '" + name + "'");
    const Hdf5Handle data(H5Dopen2(id, name.c_str(), H5P_DEFAULT), H5Dclose);
    if (!data.is_valid())
      fail("has no readable dataset '" + name + "'");
    const Hdf5Handle     space(H5Dget_space(data), H5Sclose);
    std::vector<hsize_t> extent(std::max(0, H5Sget_simple_extent_ndims(space)));
    H5Sget_simple_extent_dims(space, extent.data(), nullptr);
    return {extent.begin(), extent.end()};
  }



  std::uint64_t
  Hdf5File::size_to_read(const std::string &name,
                         const Dimensions  &extent,
                         const std::size_t  bytes) const
  {
    double needed = bytes;
    for (const std::uint64_t n : extent)
      needed *= n;
    if (!(needed <= available_memory()))
      fail("is damaged or does not fit into the memory (dataset " + name +
           " of " + rounded_text(needed / 1e9, 3) + " GB)");
    return size_of(extent);
  }



  void
  Hdf5File::read_rows(const std::string   &name,
                      const std::uint64_t  first,
                      const std::uint64_t  n,
                      std::vector<double> &values) const
  {
    std::vector<hsize_t> count = sizes(dimensions(name));
    if (count.empty() || n > count[0] || first > count[0] - n)
      fail("is shorter than it says (dataset " + name + ")");
    std::vector<hsize_t> start(count.size(), 0);
    start[0] = first;
    count[0] = n;
    values.resize(
      size_to_read(name, Dimensions(count.begin(), count.end()), 8));
    if (values.empty())
      return;
    const Hdf5Handle data(H5Dopen2(id, name.c_str(), H5P_DEFAULT), H5Dclose);
    const Hdf5Handle space(H5Dget_space(data), H5Sclose);
    const Hdf5Handle memory(
      H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr),
      H5Sclose);
    H5Sselect_hyperslab(
      space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
    if (H5Dread(
          data, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, values.data()) <
        0)
      fail("is damaged or holds no numbers (dataset " + name + ")");
  }



  std::vector<double>
  Hdf5File::read(const std::string &name) const
  {
    std::vector<double> values;
    const Dimensions    extent = dimensions(name);
    read_rows(name, 0, extent.empty() ? 0 : extent[0], values);
    return values;
  }



  std::vector<std::string>
  Hdf5File::read_texts(const std::string &name) const
  {
    const Dimensions extent = dimensions(name);
    const Hdf5Handle data(H5Dopen2(id, name.c_str(), H5P_DEFAULT), H5Dclose);
    const Hdf5Handle type(H5Dget_type(data), H5Tclose);
    if (extent.size() != 1 || H5Tget_class(type) != H5T_STRING ||
        H5Tis_variable_str(type) != 0)
      fail("holds no texts of fixed length (dataset " + name + ")");
    const std::size_t length = H5Tget_size(type);
    std::string       block(size_to_read(name, extent, length) * length, '\0');
    if (!block.empty() &&
        H5Dread(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, block.data()) < 0)
      fail("is damaged (dataset " + name + ")");
    std::vector<std::string> texts;
    for (std::uint64_t i = 0; i < extent[0]; ++i)
      texts.emplace_back(block.substr(i * length, length).c_str());
    return texts;
  }
} // namespace squeal
