// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_contact_history_h
#define squeal_results_contact_history_h

#include <squeal/base/contact_status.h>
#include <squeal/base/files.h>
#include <squeal/results/hdf5_file.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace squeal
{
  /** What a contact history tells of one pair; doc/history_format.md. */
  struct HistoryLayout
  {
    std::string name; /**< of the run */
    std::string pair; /**< of the contact pair; empty where there is one */
    /** Where the axes x, y and z of this history point to: two directions in
     * the face and its normal. */
    std::array<std::array<double, 3>, 3> axes{
      {{{1., 0., 0.}}, {{0., 1., 0.}}, {{0., 0., 1.}}}};
    /** Mean over the face of the unit directions in which the target slides,
     * along the first and the second axis; 0 where it slides all round. */
    std::array<double, 2> sliding{{0., 1.}};
    /** Along the axes, m, one a node. */
    std::vector<std::array<double, 3>> points;
    std::vector<double>                areas; /**< m^2, tributary, one a node */
    /** Pieces of the face, four nodes each in order round it, for pictures;
     * none where they are not known. */
    std::vector<std::array<unsigned int, 4>> quads;
    std::vector<std::string> probe_names;  /**< with unit, "pad_ay_m_per_s2" */
    std::vector<std::string> energy_names; /**< with unit, "kinetic_j" */
    bool                     has_slip_rate  = true;
    bool                     has_gap        = true;
    bool                     has_status     = true;
    bool                     has_resultants = true;

    std::size_t
    n_nodes() const
    {
      return points.size();
    }
  };

  /** Some samples in order of time. Arrays hold node after node for the first
   * sample, then for the second; what the layout lacks is empty. */
  struct HistorySamples
  {
    std::vector<double> time;       /**< s */
    std::vector<double> pressure;   /**< Pa, compression positive */
    std::vector<double> traction;   /**< Pa, x and y, by the disc on the pad */
    std::vector<double> slip_rate;  /**< m/s, x and y, disc minus pad */
    std::vector<double> gap;        /**< m */
    std::vector<double> status;     /**< ContactStatus as a number */
    std::vector<double> resultants; /**< N: x, y, normal */
    std::vector<double> probes;
    std::vector<double> energies;

    std::size_t
    n_samples() const
    {
      return time.size();
    }

    void clear();
  };

  /** A change of status with its time, between samples too. */
  struct StatusChange
  {
    double        time   = 0.; /**< s */
    std::size_t   node   = 0;
    ContactStatus status = ContactStatus::open; /**< from then on */
  };

  /**
   * Writes a contact history, in pieces; the file has its name only after
   * finish(). Fields of nodes are kept as 32-bit numbers, all else in double.
   * One pair makes a file of version 1, several make one of version 2.
   */
  class HistoryWriter
  {
  public:
    static constexpr int format_version = 1, version_of_pairs = 2;
    /** What sealed_file.h calls a history that squeal has written. */
    static constexpr const char *sealed_kind = "contact history";

    HistoryWriter(const std::string &path, const HistoryLayout &layout);
    /** Of pairs with different names. */
    HistoryWriter(const std::string                &path,
                  const std::vector<HistoryLayout> &pairs);

    /** Adds samples of pair number @p pair. The number of values must fit its
     * layout. All pairs have the same times and energies. */
    void append(const HistorySamples &samples, const std::size_t pair = 0);

    void append(const std::vector<StatusChange> &changes,
                const std::size_t                pair = 0);

    /** Marks the file as complete and gives it its name. */
    void finish();

  private:
    void create(const HistoryLayout &layout, const std::string &group);

    std::vector<HistoryLayout> layouts;
    AtomicFile                 target;
    std::unique_ptr<Hdf5File>  file;
  };

  /**
   * Reads a contact history in pieces. Throws InputError, one line with the
   * file's name, for a file that is missing, no HDF5, truncated, incomplete, of
   * another format or version, without a dataset, with datasets that do not fit
   * each other, with an area that is not positive, with a value that is not a
   * number, or with times that do not increase. Of a history that squeal has
   * written the checksum decides; one from elsewhere is first read to its end
   * by a child process, since HDF5 itself crashes on some damaged files.
   */
  class HistoryReader
  {
  public:
    /** @p pair: which one to read, of a file with several. Throws InputError,
     * naming those that are there, where it is none of them, and without one
     * where there are several. */
    explicit HistoryReader(const std::string &path,
                           const std::string &pair = "");

    /** The pairs of a file, empty where it has one without a name. Throws
     * InputError as the constructor. */
    static std::vector<std::string> pairs_of(const std::string &path);

    const HistoryLayout &layout() const;

    std::uint64_t n_samples() const;

    /** Times of the first and of the last sample, s. */
    std::array<double, 2> time_range() const;

    /** First sample that is not before @p time. */
    std::uint64_t sample_at(double time) const;

    /** Reads @p n samples from @p first on. */
    void read(std::uint64_t   first,
              std::uint64_t   n,
              HistorySamples &samples) const;

    std::vector<StatusChange> status_changes() const;

    const std::string &path() const;

  private:
    struct Accepted
    {
    };

    /** After its file has been found to be whole. */
    HistoryReader(const std::string &path, const std::string &pair, Accepted);

    void read_layout();

    /** @p path, if its file is one that can be read to its end. */
    static const std::string &accepted(const std::string &path);

    /** Reads all there is. */
    void read_to_end() const;

    void check_shape(const std::string          &name,
                     const Hdf5File::Dimensions &row) const;

    Hdf5File      file;
    std::string   group; /**< of the pair, with a slash at the end */
    HistoryLayout what;
    std::uint64_t samples = 0;
  };
} // namespace squeal

#endif
