// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/base/root_action.h>
#include <squeal/base/sealed_file.h>
#include <squeal/base/state_files.h>
#include <squeal/results/hdf5_file.h>
#include <squeal/run/checkpoints.h>

#include <filesystem>

namespace squeal
{
  namespace fs = std::filesystem;

  namespace
  {
    constexpr double checkpoint_version = 5.;

    /** A file as it was found. */
    struct Candidate
    {
      std::string  path;
      bool         is_damaged = false;
      std::string  difference; /**< from this run; empty: it is its own */
      NamedNumbers state;

      bool
      is_usable() const
      {
        return !is_damaged && difference.empty();
      }
    };

    Candidate
    read(const std::string &path, const Fingerprint &fingerprint)
    {
      Candidate result;
      result.path       = path;
      result.is_damaged = !is_whole_file(path, state_kind::checkpoint);
      if (result.is_damaged)
        return result;
      const Hdf5File file(path, Hdf5File::Mode::read);
      const double   version = file.number_attribute("format_version");
      if (version != checkpoint_version)
        {
          result.difference =
            "its format is version " +
            std::to_string(static_cast<int>(version)) +
            ", that of this program is " +
            std::to_string(static_cast<int>(checkpoint_version));
          return result;
        }
      result.difference =
        fingerprint.difference(file.read_texts("fingerprint").at(0));
      if (result.is_usable())
        for (const std::string &name : file.read_texts("names"))
          result.state.set(name, file.read("state/" + name));
      return result;
    }
  } // namespace



  Checkpoints::Checkpoints(const std::string &path,
                           const Fingerprint &fingerprint,
                           const std::string &way)
    : last(path)
    , before(name_before(path))
    , fingerprint(fingerprint)
    , way_to_start_anew(way)
  {
  }



  std::string
  Checkpoints::name_before(const std::string &path)
  {
    const fs::path file(path);
    return (file.parent_path() /
            (file.stem().string() + "_before" + file.extension().string()))
      .string();
  }



  Checkpoints::Found
  Checkpoints::find(const bool resume) const
  {
    Found                  found;
    std::vector<Candidate> others;
    std::string            damaged;
    for (const std::string &path : {last, before})
      {
        std::error_code error;
        if (!fs::exists(path, error))
          continue;
        if (!resume)
          {
            found.notes.push_back("checkpoint '" + path +
                                  "' is not used, as Transient/Resume is "
                                  "false; kept as '" +
                                  set_aside(path) + "'");
            continue;
          }
        Candidate candidate = read(path, fingerprint);
        if (candidate.is_usable() && found.file.empty())
          {
            found.file  = path;
            found.state = std::move(candidate.state);
          }
        if (candidate.is_damaged)
          damaged = path;
        if (!candidate.is_usable())
          others.push_back(std::move(candidate));
      }
    if (found.file.empty() && !damaged.empty())
      throw InputError("checkpoint '" + damaged +
                       "' is damaged and there is no whole one of this run: "
                       "move it away or " +
                       way_to_start_anew + " to start anew");
    for (const Candidate &other : others)
      found.notes.push_back(
        "checkpoint '" + other.path + "' is " +
        (other.is_damaged ? "damaged" : "of another run: " + other.difference) +
        "; kept as '" + set_aside(other.path) + "'");
    return found;
  }



  NamedNumbers
  Checkpoints::group_of_newest(const std::string &path,
                               const std::string &group,
                               const bool         is_root)
  {
    return NamedNumbers::from_bytes(on_root(is_root, [&]() {
      NamedNumbers state;
      for (const std::string &name : {path, name_before(path)})
        {
          if (!is_whole_file(name, state_kind::checkpoint))
            continue;
          const Hdf5File file(name, Hdf5File::Mode::read);
          if (file.number_attribute("format_version") != checkpoint_version)
            continue;
          for (const std::string &array : file.read_texts("names"))
            if (array.compare(0, group.size() + 1, group + "/") == 0)
              state.set(array, file.read("state/" + array));
          break;
        }
      return state.group(group).bytes();
    }));
  }

  void
  Checkpoints::write(const NamedNumbers &state) const
  {
    AtomicFile target(last);
    {
      Hdf5File file(target.temporary(), Hdf5File::Mode::create_sealed);
      file.write_attribute("format_version", checkpoint_version);
      file.write("fingerprint", std::vector<std::string>{fingerprint.text()});
      std::vector<std::string> names;
      for (const auto &[name, values] : state.all())
        {
          names.push_back(name);
          file.write("state/" + name, {values.size()}, values);
        }
      file.write("names", names);
      file.close();
    }
    seal_file(target.temporary(), state_kind::checkpoint);
    std::error_code error;
    if (fs::exists(last, error))
      {
        fs::rename(last, before, error);
        if (error)
          throw InputError("cannot rename '" + last + "': " + error.message());
      }
    target.commit();
  }



  void
  Checkpoints::remove() const
  {
    std::error_code error;
    for (const std::string &path : {last, before})
      if (is_state_file(path, state_kind::checkpoint))
        fs::remove(path, error);
  }

  const std::string &
  Checkpoints::path() const
  {
    return last;
  }
} // namespace squeal
