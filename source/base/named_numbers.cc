// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/named_numbers.h>
#include <squeal/base/packing.h>

#include <algorithm>
#include <cstring>

namespace squeal
{
  std::size_t
  whole_number(const double       value,
               const std::size_t  largest,
               const std::string &name)
  {
    // a NaN is in no order with anything
    if (!(value >= 0. && value <= static_cast<double>(largest)) ||
        value != static_cast<double>(static_cast<std::size_t>(value)))
      throw InputError("'" + name + "' holds " + std::to_string(value) +
                       ", which is no whole number from 0 to " +
                       std::to_string(largest));
    return static_cast<std::size_t>(value);
  }



  void
  NamedNumbers::set(const std::string &name, const std::vector<double> &values)
  {
    arrays[name] = values;
  }

  void
  NamedNumbers::set(const std::string &name, const double value)
  {
    arrays[name] = {value};
  }

  void
  NamedNumbers::set(const std::string &name, const Eigen::MatrixXd &values)
  {
    arrays[name].assign(values.data(), values.data() + values.size());
  }

  void
  NamedNumbers::set(const std::string &group, const NamedNumbers &others)
  {
    for (const auto &[name, values] : others.arrays)
      arrays[group + "/" + name] = values;
  }



  bool
  NamedNumbers::has(const std::string &name) const
  {
    return arrays.count(name) > 0;
  }

  const std::vector<double> &
  NamedNumbers::get(const std::string &name) const
  {
    const auto found = arrays.find(name);
    if (found == arrays.end())
      throw InputError("'" + name + "' is missing");
    return found->second;
  }

  const std::vector<double> &
  NamedNumbers::get(const std::string &name, const std::size_t size) const
  {
    const std::vector<double> &values = get(name);
    if (values.size() != size)
      throw InputError("'" + name + "' holds " + std::to_string(values.size()) +
                       " numbers where " + std::to_string(size) +
                       " are needed");
    return values;
  }

  double
  NamedNumbers::number(const std::string &name) const
  {
    return get(name, 1)[0];
  }

  std::size_t
  NamedNumbers::count(const std::string &name, const std::size_t largest) const
  {
    return whole_number(number(name), largest, name);
  }

  Eigen::MatrixXd
  NamedNumbers::matrix(const std::string &name,
                       const Eigen::Index n_rows,
                       const Eigen::Index n_columns) const
  {
    return Eigen::Map<const Eigen::MatrixXd>(
      get(name, n_rows * n_columns).data(), n_rows, n_columns);
  }

  Eigen::VectorXd
  NamedNumbers::vector(const std::string &name, const Eigen::Index size) const
  {
    return Eigen::Map<const Eigen::VectorXd>(get(name, size).data(), size);
  }

  NamedNumbers
  NamedNumbers::group(const std::string &group) const
  {
    const std::string start = group + "/";
    NamedNumbers      result;
    for (const auto &[name, values] : arrays)
      if (name.compare(0, start.size(), start) == 0)
        result.arrays[name.substr(start.size())] = values;
    return result;
  }

  const std::map<std::string, std::vector<double>> &
  NamedNumbers::all() const
  {
    return arrays;
  }



  std::string
  NamedNumbers::bytes() const
  {
    Packer packer;
    packer.put(arrays.size());
    for (const auto &[name, values] : arrays)
      {
        packer.put(name);
        packer.put(values);
      }
    return {packer.bytes().begin(), packer.bytes().end()};
  }

  NamedNumbers
  NamedNumbers::from_bytes(const std::string &bytes)
  {
    const std::vector<char> list(bytes.begin(), bytes.end());
    Unpacker                unpacker(list);
    std::size_t             n;
    unpacker.get(n);
    NamedNumbers result;
    for (std::size_t i = 0; i < n; ++i)
      {
        std::string name;
        unpacker.get(name);
        unpacker.get(result.arrays[name]);
      }
    return result;
  }



  bool
  NamedNumbers::operator==(const NamedNumbers &other) const
  {
    const auto is_same = [](const auto &a, const auto &b) {
      return a.first == b.first && a.second.size() == b.second.size() &&
             (a.second.empty() ||
              std::memcmp(a.second.data(),
                          b.second.data(),
                          a.second.size() * sizeof(double)) == 0);
    };
    return arrays.size() == other.arrays.size() &&
           std::equal(
             arrays.begin(), arrays.end(), other.arrays.begin(), is_same);
  }
} // namespace squeal
