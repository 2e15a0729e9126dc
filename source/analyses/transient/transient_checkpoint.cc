// SPDX-License-Identifier: LGPL-2.1-or-later

// What checkpoints keep of a TransientRun: every field by its name.

#include <squeal/analyses/transient/transient_run.h>
#include <squeal/base/exceptions.h>

#include <algorithm>

namespace squeal
{
  namespace
  {
    constexpr std::size_t last_status =
      static_cast<std::size_t>(ContactStatus::slip);

    template <typename T>
    using Fields = std::vector<std::pair<std::string, double T::*>>;

    const Fields<TransientSample> sample_fields = {
      {"time", &TransientSample::time},
      {"tangential", &TransientSample::tangential},
      {"radial", &TransientSample::radial},
      {"normal", &TransientSample::normal},
      {"n_open", &TransientSample::n_open},
      {"n_stick", &TransientSample::n_stick},
      {"is_linear", &TransientSample::is_linear},
      {"leading_edge", &TransientSample::leading_edge},
      {"kinetic", &TransientSample::kinetic},
      {"elastic", &TransientSample::elastic},
      {"damping", &TransientSample::damping},
      {"friction", &TransientSample::friction},
      {"driving", &TransientSample::driving},
      {"load", &TransientSample::load},
      {"numerical", &TransientSample::numerical},
      {"imbalance", &TransientSample::imbalance}};
    static_assert(sizeof(TransientSample) == 16 * sizeof(double),
                  "every member of a sample is kept");

    const Fields<StepForces> step_fields = {
      {"time", &StepForces::time},
      {"normal", &StepForces::normal},
      {"tangential", &StepForces::tangential},
      {"first_moment", &StepForces::first_moment},
      {"second_moment", &StepForces::second_moment}};
    static_assert(sizeof(StepForces) == 5 * sizeof(double),
                  "every member of a step's forces is kept");

    const Fields<PairSample> pair_fields = {
      {"tangential", &PairSample::tangential},
      {"radial", &PairSample::radial},
      {"normal", &PairSample::normal},
      {"pressing", &PairSample::pressing},
      {"pulling", &PairSample::pulling},
      {"first_moment", &PairSample::first_moment},
      {"second_moment", &PairSample::second_moment},
      {"friction", &PairSample::friction}};
    static_assert(sizeof(PairSample) == (8 + 2 * 3) * sizeof(double),
                  "every member of a pair is kept: 8 numbers, 2 vectors");

    const Fields<NodeShares> node_fields = {
      {"open", &NodeShares::open},
      {"stick", &NodeShares::stick},
      {"slip", &NodeShares::slip},
      {"fastest_slip", &NodeShares::fastest_slip},
      {"peak_pressure", &NodeShares::peak_pressure}};
    static_assert(sizeof(NodeShares) == 5 * sizeof(double),
                  "every member of a node's shares is kept");

    const Fields<ForceStatistics> stretch_fields = {
      {"n_steps", &ForceStatistics::n_steps},
      {"mean_normal", &ForceStatistics::mean_normal},
      {"square_normal", &ForceStatistics::square_normal},
      {"mean_tangential", &ForceStatistics::mean_tangential},
      {"square_tangential", &ForceStatistics::square_tangential},
      {"min_normal", &ForceStatistics::min_normal},
      {"max_normal", &ForceStatistics::max_normal},
      {"mean_edge", &ForceStatistics::mean_edge},
      {"mean_pressing", &ForceStatistics::mean_pressing},
      {"mean_friction", &ForceStatistics::mean_friction},
      {"n_apart", &ForceStatistics::n_apart},
      {"moment_normal", &ForceStatistics::moment_normal},
      {"moment_tangential", &ForceStatistics::moment_tangential},
      {"mean_first", &ForceStatistics::mean_first},
      {"square_first", &ForceStatistics::square_first},
      {"moment_first", &ForceStatistics::moment_first},
      {"mean_second", &ForceStatistics::mean_second},
      {"square_second", &ForceStatistics::square_second},
      {"moment_second", &ForceStatistics::moment_second},
      {"mixed_moments", &ForceStatistics::mixed_moments}};
    static_assert(sizeof(ForceStatistics) == 20 * sizeof(double),
                  "every member of a stretch is kept");

    const Fields<SignalPiece> piece_fields = {{"n", &SignalPiece::n},
                                              {"mean", &SignalPiece::mean},
                                              {"moment", &SignalPiece::moment},
                                              {"square", &SignalPiece::square}};
    static_assert(sizeof(SignalPiece) == 4 * sizeof(double),
                  "every member of a piece is kept");

    const Fields<TransientRecord> counters = {
      {"n_steps", &TransientRecord::n_steps},
      {"n_iterations", &TransientRecord::n_iterations},
      {"n_sweeps", &TransientRecord::n_sweeps},
      {"worst_residual", &TransientRecord::worst_residual},
      {"n_changes", &TransientRecord::n_changes},
      {"cpu_seconds", &TransientRecord::cpu_seconds},
      {"n_inversions", &TransientRecord::n_inversions}};

    const std::vector<
      std::pair<std::string, std::vector<double> HistorySamples::*>>
      history_fields = {{"time", &HistorySamples::time},
                        {"pressure", &HistorySamples::pressure},
                        {"traction", &HistorySamples::traction},
                        {"slip_rate", &HistorySamples::slip_rate},
                        {"gap", &HistorySamples::gap},
                        {"status", &HistorySamples::status},
                        {"resultants", &HistorySamples::resultants},
                        {"probes", &HistorySamples::probes},
                        {"energies", &HistorySamples::energies}};
    static_assert(sizeof(HistorySamples) == 9 * sizeof(std::vector<double>),
                  "every array of a history is kept");

    const std::vector<std::pair<std::string, Eigen::VectorXd MotionFrame::*>>
      frame_fields = {{"coordinates", &MotionFrame::coordinates},
                      {"forces", &MotionFrame::forces},
                      {"unknowns", &MotionFrame::unknowns}};



    /** Each field of all members of a list as one array. */
    template <typename T>
    NamedNumbers
    by_field(const std::vector<T> &list, const Fields<T> &fields)
    {
      NamedNumbers result;
      for (const auto &[name, field] : fields)
        {
          std::vector<double> values;
          for (const T &member : list)
            values.push_back(member.*field);
          result.set(name, values);
        }
      return result;
    }

    template <typename T>
    std::vector<T>
    from_fields(const NamedNumbers &numbers, const Fields<T> &fields)
    {
      std::vector<T> list(numbers.get(fields[0].first).size());
      for (const auto &[name, field] : fields)
        {
          const auto &values = numbers.get(name, list.size());
          for (std::size_t i = 0; i < list.size(); ++i)
            list[i].*field = values[i];
        }
      return list;
    }



    using PairVector = double (PairSample::*)[3];

    const std::vector<std::pair<std::string, PairVector>> pair_vectors = {
      {"position", &PairSample::position},
      {"acceleration", &PairSample::acceleration}};

    NamedNumbers
    numbers_of(const std::vector<PairSample> &samples)
    {
      NamedNumbers result = by_field(samples, pair_fields);
      for (const auto &[name, vector] : pair_vectors)
        {
          std::vector<double> values;
          for (const PairSample &s : samples)
            values.insert(values.end(), s.*vector, s.*vector + 3);
          result.set(name, values);
        }
      return result;
    }

    /** @p n samples. */
    std::vector<PairSample>
    pairs_from(const NamedNumbers &numbers, const std::size_t n)
    {
      numbers.get("normal", n);
      auto samples = from_fields(numbers, pair_fields);
      for (const auto &[name, vector] : pair_vectors)
        {
          const auto &values = numbers.get(name, 3 * samples.size());
          for (std::size_t i = 0; i < samples.size(); ++i)
            for (unsigned int c = 0; c < 3; ++c)
              (samples[i].*vector)[c] = values[3 * i + c];
        }
      return samples;
    }



    NamedNumbers
    numbers_of(const HistorySamples &history)
    {
      NamedNumbers result;
      for (const auto &[name, field] : history_fields)
        result.set(name, history.*field);
      return result;
    }

    /** @p n_nodes numbers of each field of a node. */
    HistorySamples
    history_from(const NamedNumbers &numbers, const std::size_t n_nodes)
    {
      HistorySamples history;
      for (const auto &[name, field] : history_fields)
        history.*field = numbers.get(name);
      const std::size_t n = history.n_samples();
      for (const auto &[name, size] :
           {std::pair<const char *, std::size_t>{"pressure", n_nodes},
            {"traction", 2 * n_nodes},
            {"slip_rate", 2 * n_nodes},
            {"gap", n_nodes},
            {"status", n_nodes},
            {"resultants", 3},
            {"probes", 3},
            {"energies", 7}})
        numbers.get(name, n * size);
      return history;
    }



    NamedNumbers
    numbers_of(const std::vector<MotionFrame> &frames)
    {
      NamedNumbers result;
      for (const auto &[name, part] : frame_fields)
        {
          std::vector<double> values;
          for (const MotionFrame &frame : frames)
            values.insert(values.end(),
                          (frame.*part).data(),
                          (frame.*part).data() + (frame.*part).size());
          result.set(name, values);
        }
      return result;
    }

    /** Frames at @p times whose vectors are as long as those of @p like. */
    std::vector<MotionFrame>
    frames_from(const NamedNumbers        &numbers,
                const std::vector<double> &times,
                const MotionFrame         &like)
    {
      std::vector<MotionFrame> frames(times.size());
      for (const auto &[name, part] : frame_fields)
        {
          const Eigen::MatrixXd all =
            numbers.matrix(name, (like.*part).size(), frames.size());
          for (std::size_t k = 0; k < frames.size(); ++k)
            frames[k].*part = all.col(k);
        }
      for (std::size_t k = 0; k < frames.size(); ++k)
        frames[k].time = times[k];
      return frames;
    }



    /** How many of the first @p n_done steps of @p n_steps are among those that
     * WatchedNodes keeps one by one. */
    std::size_t
    n_of_the_last(const unsigned int n_done, const unsigned int n_steps)
    {
      constexpr unsigned int most  = WatchedNodes::most_last_steps;
      const unsigned int     first = n_steps > most ? n_steps - most : 0;
      return n_done > first ? n_done - first : 0;
    }

    ContactStatus
    status_from(const double value)
    {
      return static_cast<ContactStatus>(
        whole_number(value, last_status, "status"));
    }

  } // namespace



  NamedNumbers
  TransientRun::memory() const
  {
    NamedNumbers result;
    result.set("integrator", motion->memory());
    for (const auto &[name, counter] : counters)
      result.set("counters/" + name, kept.*counter);
    result.set("samples", by_field(kept.samples, sample_fields));
    result.set("pairs", numbers_of(kept.pairs));
    result.set("last_steps", by_field(kept.last_steps, step_fields));
    result.set("nodes", by_field(kept.nodes, node_fields));
    result.set("stretches", by_field(kept.stretches, stretch_fields));
    if (!kept.pair_stretches.empty())
      result.set("pair_stretches",
                 by_field(kept.pair_stretches, stretch_fields));
    if (!kept.trigger_stretches.empty())
      {
        result.set("trigger_stretches",
                   by_field(kept.trigger_stretches, stretch_fields));
        result.set("watched/trigger_pieces",
                   by_field(kept.watched.trigger_pieces, piece_fields));
      }
    result.set("watched/pieces", by_field(kept.watched.pieces, piece_fields));
    result.set("watched/samples", kept.watched.samples);
    result.set("watched/last_steps", kept.watched.last_steps);
    result.set("square_accelerations", kept.square_accelerations);
    for (std::size_t i = 0; i < kept.frame_nodes.size(); ++i)
      result.set("frame_nodes/" + std::to_string(i),
                 numbers_of(kept.frame_nodes[i]));
    result.set("frames", numbers_of(kept.frames));
    std::vector<double> real, imaginary, states;
    for (const std::complex<double> &a : kept.amplitudes)
      {
        real.push_back(a.real());
        imaginary.push_back(a.imag());
      }
    for (const ContactStatus s : status)
      states.push_back(static_cast<double>(s));
    result.set("amplitudes/real", real);
    result.set("amplitudes/imaginary", imaginary);
    result.set("status", states);
    result.set("last_motion", Eigen::MatrixXd(last_motion));
    result.set("linear_since_sample", linear_since_sample ? 1. : 0.);
    return result;
  }



  void
  TransientRun::restore(const NamedNumbers &memory)
  {
    const std::size_t n_nodes = status.size();
    TransientRecord   record;
    for (const auto &[name, counter] : counters)
      record.*counter = memory.number("counters/" + name);
    whole_number(record.n_steps, n_steps, "counters/n_steps");
    record.samples = from_fields(memory.group("samples"), sample_fields);
    record.pairs =
      pairs_from(memory.group("pairs"),
                 record.samples.size() * pressed.nodes().pairs().size());
    record.last_steps = from_fields(memory.group("last_steps"), step_fields);
    const auto &real  = memory.get(
      "amplitudes/real", record.samples.size() * recorded.lambda.size());
    const auto &imaginary = memory.get("amplitudes/imaginary", real.size());
    for (std::size_t i = 0; i < real.size(); ++i)
      record.amplitudes.emplace_back(real[i], imaginary[i]);
    memory.get("nodes/open", n_nodes);
    record.nodes = from_fields(memory.group("nodes"), node_fields);
    memory.get("stretches/n_steps", n_force_stretches);
    record.stretches = from_fields(memory.group("stretches"), stretch_fields);
    if (!kept.pair_stretches.empty())
      {
        memory.get("pair_stretches/n_steps", kept.pair_stretches.size());
        record.pair_stretches =
          from_fields(memory.group("pair_stretches"), stretch_fields);
      }
    const std::size_t n_watched = kept.watched.numbers.size();
    record.watched.numbers      = kept.watched.numbers;
    memory.get("watched/pieces/n", n_watched * n_force_stretches);
    record.watched.pieces =
      from_fields(memory.group("watched/pieces"), piece_fields);
    if (!kept.trigger_stretches.empty())
      {
        memory.get("trigger_stretches/n_steps", kept.trigger_stretches.size());
        record.trigger_stretches =
          from_fields(memory.group("trigger_stretches"), stretch_fields);
        memory.get("watched/trigger_pieces/n", n_watched * n_trigger_stretches);
        record.watched.trigger_pieces =
          from_fields(memory.group("watched/trigger_pieces"), piece_fields);
      }
    record.watched.samples =
      memory.get("watched/samples", n_watched * record.samples.size());
    record.watched.last_steps = memory.get(
      "watched/last_steps",
      n_watched *
        n_of_the_last(static_cast<unsigned int>(record.n_steps), n_steps));
    record.square_accelerations =
      memory.get("square_accelerations", pressed.nodes().pairs().size());
    std::vector<double> frame_times;
    for (const ContactPair &pair : pressed.nodes().pairs())
      {
        const std::string number = std::to_string(record.frame_nodes.size());
        record.frame_nodes.push_back(
          history_from(memory.group("frame_nodes/" + number), pair.n_nodes()));
        frame_times = record.frame_nodes.back().time;
      }
    MotionFrame like;
    like.coordinates = motion->coordinates();
    like.forces      = motion->forces();
    if (const Eigen::VectorXd *all = motion->unknowns())
      like.unknowns = *all;
    record.frames      = frames_from(memory.group("frames"), frame_times, like);
    const auto &states = memory.get("status", n_nodes);
    last_motion        = memory.vector("last_motion", last_motion.size());
    linear_since_sample = memory.count("linear_since_sample", 1) == 1;
    motion->restore(memory.group("integrator"));
    for (std::size_t j = 0; j < n_nodes; ++j)
      status[j] = status_from(states[j]);
    kept = std::move(record);
  }



  bool
  TransientRun::moves_all_unknowns() const
  {
    return motion->unknowns() != nullptr;
  }

  void
  TransientRun::describe(Fingerprint &fingerprint) const
  {
    const auto add = [&](const std::string &name, const std::size_t number) {
      fingerprint.add(name, std::to_string(number));
    };
    add("contact nodes", status.size());
    add("contact pairs", pressed.nodes().pairs().size());
    add("modes", motion->coordinates().size());
    add("unknowns that move",
        motion->unknowns() ? motion->unknowns()->size() : 0);
    add("pairs recorded", recorded.lambda.size());
    add("steps", n_steps);
  }
} // namespace squeal
