// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_named_numbers_h
#define squeal_base_named_numbers_h

#include <Eigen/Core>

#include <map>
#include <string>
#include <vector>

namespace squeal
{
  /**
   * Arrays of numbers by name: what a computation continues from, as a
   * checkpoint keeps it. Whoever reads one says how long it must be; what does
   * not fit throws InputError with its name and both lengths.
   */
  class NamedNumbers
  {
  public:
    void set(const std::string &name, const std::vector<double> &values);
    void set(const std::string &name, const double value);
    /** Column by column. */
    void set(const std::string &name, const Eigen::MatrixXd &values);
    /** All of @p others, with @p group and '/' in front of their names. */
    void set(const std::string &group, const NamedNumbers &others);

    bool has(const std::string &name) const;

    const std::vector<double> &get(const std::string &name) const;
    const std::vector<double> &get(const std::string &name,
                                   const std::size_t  size) const;
    double                     number(const std::string &name) const;
    /** A whole number from 0 to @p largest. */
    std::size_t count(const std::string &name, const std::size_t largest) const;
    Eigen::MatrixXd matrix(const std::string &name,
                           const Eigen::Index n_rows,
                           const Eigen::Index n_columns) const;
    Eigen::VectorXd vector(const std::string &name,
                           const Eigen::Index size) const;
    /** Those in front of whose names set() has put @p group. */
    NamedNumbers group(const std::string &group) const;

    const std::map<std::string, std::vector<double>> &all() const;

    /** @name All of it as bytes, for messages between ranks */
    //@{
    std::string         bytes() const;
    static NamedNumbers from_bytes(const std::string &bytes);
    //@}

    /** Bit by bit. */
    bool operator==(const NamedNumbers &other) const;

  private:
    std::map<std::string, std::vector<double>> arrays;
  };

  /** @p value as a whole number from 0 to @p largest; throws InputError with
   * @p name where it is none. */
  std::size_t whole_number(const double       value,
                           const std::size_t  largest,
                           const std::string &name);
} // namespace squeal

#endif
