// SPDX-License-Identifier: LGPL-2.1-or-later

// The basis of a SweepModel as later runs find it.

#include <squeal/analyses/sweep/sweep_model.h>
#include <squeal/base/checksum.h>
#include <squeal/base/root_action.h>
#include <squeal/base/sealed_file.h>
#include <squeal/base/state_files.h>
#include <squeal/parameters/numbers.h>

#include <filesystem>

namespace squeal
{
  namespace
  {
    /** Numbers with all their digits. */
    template <typename List>
    std::string
    digits(const List &numbers)
    {
      std::string text;
      for (const double number : numbers)
        text += (text.empty() ? "" : " ") + prm::format_number(number);
      return text;
    }

    const std::string rounds_name = "rounds";

    enum RoundColumn
    {
      size_column,
      factor_column,
      frequency_column,
      sigma_column,
      seconds_column,
      n_columns
    };
  } // namespace



  std::string
  SweepModel::basis_file(RunContext &context, const std::string &name)
  {
    const std::string    &asked = context.parameters.sweep.basis_file;
    std::filesystem::path path  = asked.empty() ? "basis.h5" : asked;
    if (!name.empty())
      path.replace_filename(path.stem().string() + "_" + name +
                            path.extension().string());
    return on_root(context.is_root, [&]() {
      return context.output.state_file(
        path.string(), state_kind::basis, "Sweep/Basis file");
    });
  }



  Fingerprint
  SweepModel::fingerprint() const
  {
    Fingerprint result(parameters, Fingerprint::Purpose::basis);
    SweepPoint  first(sweep_grid.n_axes()), last(sweep_grid.n_axes());
    bool        has_laws = false;
    for (unsigned int a = 0; a < sweep_grid.n_axes(); ++a)
      {
        first[a] = sweep_grid.lower(a);
        last[a]  = sweep_grid.upper(a);
        result.add("range of axis " + sweep_grid.axis(a).name,
                   digits(std::vector<double>{first[a], last[a]}) +
                     (sweep_grid.is_logarithmic(a) ? ", logarithmic" : ""));
        // Between their ends, too, entries are where the list puts them.
        if (!sweep_grid.axis(a).entry_values.empty())
          {
            has_laws = true;
            result.add("places of entries on axis " + sweep_grid.axis(a).name,
                       digits(sweep_grid.axis(a).values));
          }
      }
    // Which parts are one depends on the values between the ends.
    if (has_laws)
      result.add("affine parts", std::to_string(parts.merged().terms.size()));
    // Entries of one axis have ranges of their own.
    result.add("values at the lower ends", digits(sweep_grid.values(first)));
    result.add("values at the upper ends", digits(sweep_grid.values(last)));
    result.add("unknowns", std::to_string(full.n_unknowns()));
    std::string states;
    for (const unsigned int number : sweep_grid.states())
      states += std::to_string(number) + " ";
    for (const auto &all : contact_states)
      for (const auto &state : all)
        {
          for (const ContactStatus status : state.status)
            states += std::to_string(static_cast<int>(status));
          states += " " + digits(state.force_share) + " ";
        }
    result.add("contact states", "checksum " + checksum_of(states));
    return result;
  }



  bool
  SweepModel::read(RunContext &context)
  {
    namespace fs = std::filesystem;
    Timers::Section section(context.timers, "Setup: saved basis");
    const auto      put_aside = [&](const std::string &reason) {
      context.log.warning("the basis in " + file + " is " + reason +
                          ": built anew, the file is kept as '" +
                          set_aside(file) + "'");
      return "";
    };
    const std::string found = on_root(context.is_root, [&]() -> std::string {
      std::error_code error;
      if (!fs::exists(file, error))
        return "";
      if (!is_whole_file(file, state_kind::basis))
        return put_aside("damaged");
      const std::string difference =
        fingerprint().difference(key_of_reduced_model(file));
      if (!difference.empty())
        return put_aside("of another sweep (" + difference + ")");
      return parameters.sweep.reuse_basis ? file : "";
    });
    reused                  = !found.empty();
    if (!reused)
      return false;
    std::string key;
    small   = read_reduced_model(file, key);
    factors = static_cast<unsigned int>(small.numbers.at("factors")(0));
    take_rounds();
    context.log.info("  basis of an earlier run: " + file);
    return true;
  }



  void
  SweepModel::put_rounds()
  {
    Eigen::MatrixXd table(rounds.size(), n_columns);
    for (std::size_t i = 0; i < rounds.size(); ++i)
      {
        table(i, size_column)      = rounds[i].basis_size;
        table(i, factor_column)    = rounds[i].n_factors;
        table(i, frequency_column) = rounds[i].worst.frequency;
        table(i, sigma_column)     = rounds[i].worst.sigma;
        table(i, seconds_column)   = rounds[i].cpu_seconds;
      }
    small.numbers[rounds_name] = table;
  }

  void
  SweepModel::take_rounds()
  {
    const Eigen::MatrixXd &table = small.numbers.at(rounds_name);
    rounds.clear();
    for (Eigen::Index i = 0; i < table.rows(); ++i)
      {
        BasisRound round;
        round.basis_size = static_cast<unsigned int>(table(i, size_column));
        round.n_factors  = static_cast<unsigned int>(table(i, factor_column));
        round.worst.frequency = table(i, frequency_column);
        round.worst.sigma     = table(i, sigma_column);
        round.cpu_seconds     = table(i, seconds_column);
        rounds.push_back(round);
      }
  }
} // namespace squeal
