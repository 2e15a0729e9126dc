// SPDX-License-Identifier: LGPL-2.1-or-later

// The file of a reduced model: HDF5 with a format version.

#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/base/hdf5_handle.h>
#include <squeal/base/input_file.h>
#include <squeal/base/open_hdf5_files.h>
#include <squeal/base/sealed_file.h>
#include <squeal/base/state_files.h>
#include <squeal/sweep/reduced_model.h>

namespace squeal
{
  namespace
  {
    constexpr int format_version = 2;

    void
    require(const bool ok, const std::string &file, const std::string &what)
    {
      if (!ok)
        throw InputError("'" + file + "' " + what +
                         ": remove it or change Sweep/Basis file");
    }

    void
    write_matrix(const hid_t            group,
                 const std::string     &name,
                 const Eigen::MatrixXd &A,
                 const std::string     &file)
    {
      // Column by column: the file's rows are the matrix's columns.
      const hsize_t    size[2] = {static_cast<hsize_t>(A.cols()),
                                  static_cast<hsize_t>(A.rows())};
      const Hdf5Handle space(H5Screate_simple(2, size, nullptr), H5Sclose);
      const Hdf5Handle set(H5Dcreate2(group,
                                      name.c_str(),
                                      H5T_IEEE_F64LE,
                                      space,
                                      H5P_DEFAULT,
                                      H5P_DEFAULT,
                                      H5P_DEFAULT),
                           H5Dclose);
      require(
        set >= 0 &&
          (A.size() == 0 ||
           H5Dwrite(
             set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, A.data()) >=
             0),
        file,
        "cannot be written");
    }

    Eigen::MatrixXd
    read_matrix(const hid_t        group,
                const std::string &name,
                const std::string &file)
    {
      const Hdf5Handle set(H5Dopen2(group, name.c_str(), H5P_DEFAULT),
                           H5Dclose);
      require(set >= 0, file, "lacks '" + name + "'");
      const Hdf5Handle space(H5Dget_space(set), H5Sclose);
      hsize_t          size[2] = {0, 0};
      require(H5Sget_simple_extent_ndims(space) == 2 &&
                H5Sget_simple_extent_dims(space, size, nullptr) == 2,
              file,
              "holds something else than a matrix in '" + name + "'");
      Eigen::MatrixXd A(size[1], size[0]);
      require(
        A.size() == 0 ||
          H5Dread(
            set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, A.data()) >=
            0,
        file,
        "is damaged at '" + name + "'");
      return A;
    }

    using Matrices = std::map<std::string, Eigen::MatrixXd>;

    void
    write_group(const hid_t        root,
                const std::string &name,
                const Matrices    &matrices,
                const std::string &file)
    {
      const Hdf5Handle group(
        H5Gcreate2(root, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
        H5Gclose);
      for (const auto &[key, A] : matrices)
        write_matrix(group, key, A, file);
    }

    Matrices
    read_group(const hid_t        root,
               const std::string &name,
               const std::string &file)
    {
      const Hdf5Handle group(H5Gopen2(root, name.c_str(), H5P_DEFAULT),
                             H5Gclose);
      require(group >= 0, file, "lacks '" + name + "'");
      H5G_info_t info;
      H5Gget_info(group, &info);
      Matrices result;
      for (hsize_t i = 0; i < info.nlinks; ++i)
        {
          char text[256];
          H5Lget_name_by_idx(group,
                             ".",
                             H5_INDEX_NAME,
                             H5_ITER_INC,
                             i,
                             text,
                             sizeof text,
                             H5P_DEFAULT);
          result[text] = read_matrix(group, text, file);
        }
      return result;
    }

    /** A text of any length: an attribute has room for 64 kB. */
    void
    write_text(const hid_t        root,
               const std::string &name,
               const std::string &text,
               const std::string &file)
    {
      const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
      H5Tset_size(type, text.size() + 1);
      const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
      const Hdf5Handle set(H5Dcreate2(root,
                                      name.c_str(),
                                      type,
                                      space,
                                      H5P_DEFAULT,
                                      H5P_DEFAULT,
                                      H5P_DEFAULT),
                           H5Dclose);
      require(
        set >= 0 &&
          H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()) >= 0,
        file,
        "cannot be written");
    }

    std::string
    read_text(const hid_t        root,
              const std::string &name,
              const std::string &file)
    {
      const Hdf5Handle set(H5Dopen2(root, name.c_str(), H5P_DEFAULT), H5Dclose);
      require(set >= 0, file, "is no basis of squeal");
      const Hdf5Handle type(H5Dget_type(set), H5Tclose);
      require(H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0,
              file,
              "holds something else than a text in '" + name + "'");
      std::string text(H5Tget_size(type), '\0');
      require(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()) >=
                0,
              file,
              "is damaged at '" + name + "'");
      return text.c_str();
    }

    /** Opens a whole file of the format that this program reads. */
    Hdf5Handle
    opened(const std::string &file)
    {
      require_input_file(file);
      require(is_sealed_file(file, state_kind::basis),
              file,
              "is no basis that squeal has written");
      require(is_whole_file(file, state_kind::basis), file, "is damaged");
      return {H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose};
    }

    std::string
    part_name(const std::size_t i)
    {
      std::string number = std::to_string(i);
      return std::string(4 - std::min<std::size_t>(4, number.size()), '0') +
             number;
    }
  } // namespace



  void
  write_reduced_model(const ReducedModel &model,
                      const std::string  &key,
                      const std::string  &file)
  {
    const Hdf5Silence silence;
    AtomicFile        target(file);
    {
      const Hdf5Handle root(H5Fcreate(target.temporary().c_str(),
                                      H5F_ACC_TRUNC,
                                      sealed_creation(),
                                      H5P_DEFAULT),
                            close_hdf5_file);
      require(root >= 0, file, "cannot be written");
      write_text(root, "version", std::to_string(format_version), file);
      write_text(root, "key", key, file);
      Matrices parts, grams, numbers = model.numbers;
      for (std::size_t i = 0; i < model.grams.size(); ++i)
        grams[part_name(i)] = model.grams[i];
      for (std::size_t i = 0; i < model.parts.size(); ++i)
        parts[part_name(i)] = model.parts[i];
      for (std::size_t c = 0; c < model.cells.size(); ++c)
        {
          const ModelCell  &cell  = model.cells[c];
          const std::string start = "cell " + part_name(c) + " ";
          numbers[start + "turn"] = cell.turn;
          numbers[start + "box"]  = Eigen::MatrixXd(cell.lower.size(), 3);
          numbers[start + "box"] << cell.lower, cell.upper,
            Eigen::VectorXd::Constant(cell.lower.size(), cell.local.n_basis);
        }
      write_group(root, "parts", parts, file);
      write_group(root, "grams", grams, file);
      write_group(root, "forms", model.forms, file);
      write_group(root, "functionals", model.functionals, file);
      write_group(root, "numbers", numbers, file);
      require(H5Fflush(root, H5F_SCOPE_LOCAL) >= 0,
              file,
              "could not be written to its end; is the disk full?");
    }
    seal_file(target.temporary(), state_kind::basis);
    target.commit();
  }



  std::string
  key_of_reduced_model(const std::string &file)
  {
    const Hdf5Silence silence;
    const Hdf5Handle  root = opened(file);
    return read_text(root, "key", file);
  }



  ReducedModel
  read_reduced_model(const std::string &file, std::string &key)
  {
    const Hdf5Silence silence;
    const Hdf5Handle  root    = opened(file);
    const std::string version = read_text(root, "version", file);
    require(version == std::to_string(format_version),
            file,
            "has the format version " + version + ", this program reads " +
              std::to_string(format_version));
    key = read_text(root, "key", file);
    ReducedModel model;
    for (auto &part : read_group(root, "parts", file))
      model.parts.push_back(std::move(part.second));
    for (auto &gram : read_group(root, "grams", file))
      model.grams.push_back(std::move(gram.second));
    model.forms          = read_group(root, "forms", file);
    model.functionals    = read_group(root, "functionals", file);
    model.numbers        = read_group(root, "numbers", file);
    const Eigen::Index N = model.n_total();
    for (const auto &part : model.parts)
      require(part.rows() == N && part.cols() == N, file, "is damaged");
    for (std::size_t c = 0;; ++c)
      {
        const std::string start = "cell " + part_name(c) + " ";
        const auto        turn  = model.numbers.find(start + "turn");
        const auto        box   = model.numbers.find(start + "box");
        if (turn == model.numbers.end() || box == model.numbers.end())
          break;
        require(turn->second.rows() == N && box->second.cols() == 3 &&
                  box->second.rows() > 0,
                file,
                "is damaged");
        ModelCell cell;
        cell.lower         = box->second.col(0);
        cell.upper         = box->second.col(1);
        cell.local.n_basis = static_cast<unsigned int>(box->second(0, 2));
        cell.turn          = turn->second;
        model.project(cell);
        model.cells.push_back(std::move(cell));
        model.numbers.erase(turn);
        model.numbers.erase(box);
      }
    require(!model.cells.empty(), file, "is damaged");
    return model;
  }
} // namespace squeal
