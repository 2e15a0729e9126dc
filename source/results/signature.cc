// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/results/signature.h>

#include <algorithm>
#include <filesystem>

namespace squeal
{
  namespace
  {
    const std::string real_part = "re_", imaginary_part = "im_";

    bool
    begins_with(const std::string &text, const std::string &start)
    {
      return text.compare(0, start.size(), start) == 0;
    }

    /** The entries in the header of @p table; none of an earlier version. */
    std::vector<std::string>
    sampled_entries(const Table &table, const std::string &path)
    {
      const auto              &columns = table.columns();
      std::vector<std::string> entries;
      if (columns.size() > 1 && columns[1].name == "c1")
        return entries;
      for (std::size_t c = 1; c < columns.size(); c += 2)
        {
          const std::string entry = columns[c].name.substr(
            std::min(real_part.size(), columns[c].name.size()));
          if (!begins_with(columns[c].name, real_part) ||
              c + 1 == columns.size() ||
              columns[c + 1].name != imaginary_part + entry)
            throw InputError(path + ": column '" + columns[c].name +
                             "' is not the real part of a sample with the "
                             "imaginary part behind it");
          entries.push_back(entry);
        }
      return entries;
    }
  } // namespace



  Table
  make_signature_table(const std::vector<long long>   &indices,
                       const std::vector<std::string> &entries,
                       const std::vector<Signature>   &samples)
  {
    Table table({{"index", Table::Type::integer, "", "number of the pair"}});
    for (const std::string &entry : entries)
      for (const std::string &part : {real_part, imaginary_part})
        table.add_column({part + entry,
                          Table::Type::real,
                          "",
                          part == real_part
                            ? "real part of a sampled displacement"
                            : "imaginary part of a sampled displacement"});
    for (std::size_t i = 0; i < samples.size(); ++i)
      {
        std::vector<Cell> row = {indices.at(i)};
        for (const std::complex<double> &sample : samples[i])
          {
            row.emplace_back(sample.real());
            row.emplace_back(sample.imag());
          }
        table.add_row(row);
      }
    return table;
  }



  double
  modal_assurance(const Signature &a, const Signature &b)
  {
    std::complex<double> product = 0.;
    double               aa = 0., bb = 0.;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
      {
        product += std::conj(a[i]) * b[i];
        aa += std::norm(a[i]);
        bb += std::norm(b[i]);
      }
    return aa > 0. && bb > 0. ? std::norm(product) / (aa * bb) : 0.;
  }



  std::size_t
  SignatureFile::n_samples() const
  {
    return of_pair.empty() ? 0 : of_pair.begin()->second.size();
  }



  SignatureFile
  read_signatures(const std::string &path)
  {
    SignatureFile   result;
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored))
      return result;
    const Table table =
      read_csv(path, {{"index", Table::Type::integer, "", ""}});
    result.entries      = sampled_entries(table, path);
    const std::size_t n = table.columns().size();
    for (std::size_t r = 0; r < table.n_rows(); ++r)
      {
        Signature signature;
        for (std::size_t c = 1; c + 1 < n; c += 2)
          signature.emplace_back(table.real(r, table.columns()[c].name),
                                 table.real(r, table.columns()[c + 1].name));
        result.of_pair[table.integer(r, "index")] = signature;
      }
    return result;
  }



  std::string
  align_signatures(SignatureFile &a, SignatureFile &b, const bool same_bodies)
  {
    const auto refused = [&](const std::string &reason) {
      a = b = SignatureFile();
      return reason;
    };
    if (a.n_samples() == 0 || b.n_samples() == 0)
      return refused("");
    const bool is_named = !a.entries.empty() && !b.entries.empty();
    if (!is_named && !same_bodies)
      return refused("a signature.csv of an earlier version names no bodies");
    const std::string other =
      "the bodies, or the points that are sampled on them, differ";
    if (a.n_samples() != b.n_samples())
      return refused(other);
    if (!is_named || a.entries == b.entries)
      return "";

    std::map<std::string, std::size_t> place_in_b;
    for (std::size_t i = 0; i < b.entries.size(); ++i)
      place_in_b[b.entries[i]] = i;
    std::vector<std::size_t> order;
    for (const std::string &entry : a.entries)
      {
        const auto found = place_in_b.find(entry);
        if (found == place_in_b.end())
          return refused(other);
        order.push_back(found->second);
      }
    for (auto &[index, signature] : b.of_pair)
      {
        Signature ordered;
        for (const std::size_t i : order)
          ordered.push_back(signature.at(i));
        signature = std::move(ordered);
      }
    b.entries = a.entries;
    return "";
  }
} // namespace squeal
