// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/base64.h>
#include <squeal/base/exceptions.h>

#include <squeal/results/vtk_xml.h>

#include <zlib.h>

#include <array>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <ostream>
#include <type_traits>

namespace squeal
{
  namespace vtk
  {
    namespace
    {
      /** VTK's layout: number of blocks, their size, size of a last partial
       * block, compressed sizes; encoded apart from the bytes that follow. */
      std::string
      compressed(const void *data, const std::size_t n, const int level)
      {
        const std::size_t          block = 1 << 20;
        std::vector<std::uint32_t> head{
          static_cast<std::uint32_t>((n + block - 1) / block),
          static_cast<std::uint32_t>(block),
          static_cast<std::uint32_t>(n % block)};
        std::string bytes;
        const auto *input = static_cast<const unsigned char *>(data);
        for (std::size_t i = 0; i < n; i += block)
          {
            const uLong       n_in  = std::min(block, n - i);
            uLongf            n_out = compressBound(n_in);
            const std::size_t old   = bytes.size();
            bytes.resize(old + n_out);
            if (compress2(reinterpret_cast<unsigned char *>(&bytes[old]),
                          &n_out,
                          input + i,
                          n_in,
                          level) != Z_OK)
              throw ComputationError("zlib could not compress a result: not "
                                     "enough memory");
            bytes.resize(old + n_out);
            head.push_back(n_out);
          }
        return base64(std::string(reinterpret_cast<const char *>(head.data()),
                                  head.size() * sizeof(head[0]))) +
               base64(bytes);
      }

      template <typename T>
      const char *
      type_name()
      {
        if (std::is_same<T, float>::value)
          return "Float32";
        if (std::is_same<T, double>::value)
          return "Float64";
        return std::is_same<T, std::int32_t>::value ? "Int32" : "UInt8";
      }

      std::string
      escaped(const std::string &text)
      {
        std::string result;
        for (const char c : text)
          switch (c)
            {
            case '<':
              result += "&lt;";
              break;
            case '>':
              result += "&gt;";
              break;
            case '&':
              result += "&amp;";
              break;
            case '"':
              result += "&quot;";
              break;
            default:
              result += c;
            }
        return result;
      }

      /** The shortest decimal text that reads back as @p value. */
      std::string
      shortest(const double value)
      {
        std::array<char, 32> buffer;
        const auto           result =
          std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
        return std::string(buffer.data(), result.ptr);
      }

      std::string
      head(const std::string &type)
      {
        const std::uint16_t one = 1;
        unsigned char       first_byte;
        std::memcpy(&first_byte, &one, 1);
        return "<?xml version=\"1.0\"?>\n<VTKFile type=\"" + type +
               "\" version=\"1.0\" byte_order=\"" +
               (first_byte == 1 ? "LittleEndian" : "BigEndian") +
               "\" header_type=\"UInt32\" "
               "compressor=\"vtkZLibDataCompressor\">\n";
      }

      std::string
      active(const char *kind, const std::string &name)
      {
        return name.empty()
                 ? ""
                 : std::string(" ") + kind + "=\"" + escaped(name) + "\"";
      }
    } // namespace



    template <typename T>
    std::string
    data_array(const std::string    &name,
               const unsigned int    n_components,
               const std::vector<T> &values,
               const int             compression)
    {
      return std::string("<DataArray type=\"") + type_name<T>() + "\" Name=\"" +
             escaped(name) + "\" NumberOfComponents=\"" +
             std::to_string(n_components) + "\" format=\"binary\">\n" +
             compressed(values.data(), values.size() * sizeof(T), compression) +
             "\n</DataArray>\n";
    }

    template std::string data_array(const std::string &,
                                    const unsigned int,
                                    const std::vector<float> &,
                                    const int);
    template std::string data_array(const std::string &,
                                    const unsigned int,
                                    const std::vector<double> &,
                                    const int);
    template std::string data_array(const std::string &,
                                    const unsigned int,
                                    const std::vector<std::int32_t> &,
                                    const int);
    template std::string data_array(const std::string &,
                                    const unsigned int,
                                    const std::vector<std::uint8_t> &,
                                    const int);



    std::string
    number(const std::string &name, const double value)
    {
      return "<DataArray type=\"Float64\" Name=\"" + escaped(name) +
             "\" NumberOfTuples=\"1\" format=\"ascii\">" + shortest(value) +
             "</DataArray>\n";
    }



    std::string
    texts(const std::string &name, const std::vector<std::string> &values)
    {
      std::string codes;
      for (const auto &value : values)
        {
          for (const unsigned char c : value)
            codes += std::to_string(c) + ' ';
          codes += "0 ";
        }
      return "<Array type=\"String\" Name=\"" + escaped(name) +
             "\" NumberOfTuples=\"" + std::to_string(values.size()) +
             "\" format=\"ascii\">" + codes + "</Array>\n";
    }



    void
    write_vtu(std::ostream &out, const UnstructuredGrid &grid)
    {
      out << head("UnstructuredGrid") << "<UnstructuredGrid>\n<FieldData>\n"
          << grid.field_data << "</FieldData>\n<Piece NumberOfPoints=\""
          << grid.n_points << "\" NumberOfCells=\"" << grid.n_cells << "\">\n"
          << "<PointData" << active("Vectors", grid.vectors) << ">\n"
          << grid.point_data << "</PointData>\n"
          << "<CellData" << active("Scalars", grid.scalars) << ">\n"
          << grid.cell_data << "</CellData>\n"
          << "<Points>\n"
          << grid.points << "</Points>\n"
          << "<Cells>\n"
          << grid.cells << "</Cells>\n"
          << "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
    }



    std::string
    collection(const std::vector<std::pair<double, std::string>> &steps)
    {
      std::string text = head("Collection") + "<Collection>\n";
      for (const auto &[time, file] : steps)
        text += "<DataSet timestep=\"" + shortest(time) +
                "\" group=\"\" part=\"0\" file=\"" + escaped(file) + "\"/>\n";
      return text + "</Collection>\n</VTKFile>\n";
    }
  } // namespace vtk
} // namespace squeal
