// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_history_stream_h
#define squeal_results_history_stream_h

#include <squeal/base/row_file.h>
#include <squeal/results/contact_history.h>

#include <string>
#include <vector>

namespace squeal
{
  /**
   * The contact histories of all pairs of a run that may be killed: samples and
   * changes of status go to two files as they come, so that memory does not
   * grow with them, and a checkpoint has their number and checksum only. At the
   * end of the run write() makes a history of them.
   */
  class HistoryStream
  {
  public:
    /** @p path of the checkpoints of the run, beside which the two files are:
     * see samples_name() and changes_name(). @p n_nodes of each pair, and the
     * numbers of probes of a pair and of energies. No file is touched. */
    HistoryStream(const std::string              &path,
                  const std::vector<std::size_t> &n_nodes,
                  const std::size_t               n_probes,
                  const std::size_t               n_energies);

    /** The files of a checkpoint @p path, "checkpoint_samples.bin". */
    static std::string samples_name(const std::string &path);
    static std::string changes_name(const std::string &path);

    /** Begins empty files. Throws InputError. */
    void start();

    /** Adds one sample of each pair, with the same time and energies. */
    void append(const std::vector<HistorySamples> &of_pairs);
    /** Nodes are numbered over all pairs. */
    void append(const StatusChange &change);

    std::size_t n_samples() const;

    /** Samples of @p pair from @p first on. */
    HistorySamples read(const std::size_t pair,
                        const std::size_t first,
                        const std::size_t n) const;

    /** First sample that is not before @p time, s; n_samples() if none. */
    std::size_t sample_at(const double time) const;

    /** Appends all of it to @p writer, which has the same pairs. */
    void write(HistoryWriter &writer) const;

    /** @name For checkpoints, see RowFile */
    //@{
    NamedNumbers memory();
    void         restore(const NamedNumbers &memory);
    void         remove();
    //@}

  private:
    void write_changes(HistoryWriter &writer) const;

    const std::vector<std::size_t> n_nodes;
    const std::size_t              n_probes, n_energies;
    std::vector<std::size_t>
            first_column; /**< of each pair, and the energies */
    RowFile samples, changes;
  };
} // namespace squeal

#endif
