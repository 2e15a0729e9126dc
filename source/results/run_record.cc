// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/results/json_file.h>
#include <squeal/results/run_record.h>

#include <nlohmann/json.hpp>

#include <ostream>

namespace squeal
{
  namespace
  {
    // entries stay in the order in which they are written
    using Json = nlohmann::ordered_json;

    template <typename Value>
    Json
    from_pairs(const std::vector<std::pair<std::string, Value>> &pairs)
    {
      Json object = Json::object();
      for (const auto &[name, value] : pairs)
        object[name] = value;
      return object;
    }

    template <typename Value>
    std::vector<std::pair<std::string, Value>>
    to_pairs(const Json &object)
    {
      std::vector<std::pair<std::string, Value>> pairs;
      for (const auto &item : object.items())
        pairs.emplace_back(item.key(), item.value().template get<Value>());
      return pairs;
    }

    Json
    from_timings(const std::vector<Timers::Entry> &timings)
    {
      Json list = Json::array();
      for (const Timers::Entry &entry : timings)
        list.push_back({{"section", entry.name},
                        {"calls", entry.count},
                        {"depth", entry.depth},
                        {"wall_s", entry.wall},
                        {"own_wall_s", entry.own_wall},
                        {"own_cpu_s", entry.own_cpu}});
      return list;
    }

    Json
    from_checks(const std::vector<ResultCheck> &checks)
    {
      Json list = Json::array();
      for (const ResultCheck &check : checks)
        {
          Json item = {{"name", check.name},
                       {"passed", check.passed},
                       {"expected", check.expected},
                       {"tolerance", check.tolerance},
                       {"rows", check.n_rows}};
          if (check.has_value)
            item["got"] = check.got;
          else
            item["reason"] = check.reason;
          list.push_back(item);
        }
      return list;
    }

    RunRecord
    from_json(const Json &json)
    {
      RunRecord record;
      record.versions       = to_pairs<std::string>(json.at("versions"));
      record.analysis       = json.at("analysis");
      record.scene          = json.at("scene");
      record.parameter_file = json.at("parameter_file");
      record.n_ranks        = json.at("ranks");
      // records of former versions have none of these
      record.settings = json.value("settings", std::vector<std::string>());
      record.void_checks =
        json.value("void_checks", std::vector<std::string>());
      record.void_cause     = json.value("void_cause", "");
      record.n_dofs         = json.at("dofs");
      record.dofs_of_bodies = to_pairs<std::size_t>(json.at("dofs_of_bodies"));
      record.figures        = to_pairs<std::string>(json.at("figures"));
      record.parameters     = to_pairs<std::string>(json.at("parameters"));
      record.total_wall     = json.at("wall_s");
      record.total_cpu      = json.at("cpu_s");
      record.peak_memory_mb = json.at("peak_memory_mb");
      record.warnings = json.at("warnings").get<std::vector<std::string>>();
      record.files    = json.at("files").get<std::vector<std::string>>();
      for (const Json &item : json.at("timings"))
        record.timings.push_back({item.at("section"),
                                  item.at("calls"),
                                  item.at("wall_s"),
                                  item.at("own_wall_s"),
                                  item.at("own_cpu_s"),
                                  item.at("depth")});
      for (const Json &item : json.at("result_checks"))
        {
          ResultCheck check;
          check.name      = item.at("name");
          check.passed    = item.at("passed");
          check.expected  = item.at("expected");
          check.tolerance = item.at("tolerance");
          check.n_rows    = item.at("rows");
          check.has_value = item.contains("got");
          check.got       = item.value("got", 0.);
          check.reason    = item.value("reason", "");
          record.checks.push_back(check);
        }
      return record;
    }
  } // namespace



  void
  RunRecord::take_timings(const Timers &timers)
  {
    timings        = timers.entries();
    total_wall     = timers.total_wall();
    total_cpu      = timers.total_cpu();
    peak_memory_mb = squeal::peak_memory_mb();
  }



  void
  write_run_record(const RunRecord &record, const std::string &path)
  {
    const Json json = {{"format_version", RunRecord::format_version},
                       {"versions", from_pairs(record.versions)},
                       {"analysis", record.analysis},
                       {"scene", record.scene},
                       {"parameter_file", record.parameter_file},
                       {"settings", record.settings},
                       {"ranks", record.n_ranks},
                       {"dofs", record.n_dofs},
                       {"dofs_of_bodies", from_pairs(record.dofs_of_bodies)},
                       {"figures", from_pairs(record.figures)},
                       {"result_checks", from_checks(record.checks)},
                       {"void_checks", record.void_checks},
                       {"void_cause", record.void_cause},
                       {"warnings", record.warnings},
                       {"wall_s", record.total_wall},
                       {"cpu_s", record.total_cpu},
                       {"peak_memory_mb", record.peak_memory_mb},
                       {"timings", from_timings(record.timings)},
                       {"files", record.files},
                       {"parameters", from_pairs(record.parameters)}};
    write_json(path, json);
  }



  RunRecord
  read_run_record(const std::string &path)
  {
    const std::string content = read_file(path);
    try
      {
        const Json json    = Json::parse(content);
        const int  version = json.at("format_version");
        if (version != RunRecord::format_version)
          throw InputError("'" + path + "' has format version " +
                           std::to_string(version) + "; this program reads " +
                           std::to_string(RunRecord::format_version));
        return from_json(json);
      }
    catch (const Json::exception &e)
      {
        throw InputError("'" + path +
                         "' is not the record of a run: " + e.what());
      }
  }
} // namespace squeal
