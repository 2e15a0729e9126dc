// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/choices.h>
#include <squeal/tribology/driver/context.h>

namespace squeal::tribology
{
  namespace
  {
    RunDescription
    description_of(const TribologyParameters &p, const RunOptions &options)
    {
      return {choice_name(p.analysis),
              p.name,
              p.file,
              p.used,
              p.notes,
              p.result_checks,
              p.output.directory,
              p.output.overwrite,
              1,
              options};
    }
  } // namespace



  Context::Context(const TribologyParameters &p, const RunOptions &options)
    : RunSession(description_of(p, options), *GenericTribologySchema(), true)
    , parameters(p)
  {
  }



  std::string
  Context::plot_path(const std::string &name)
  {
    const std::string path = output.file("plots/" + name + ".png");
    return path.substr(0, path.size() - 4);
  }
} // namespace squeal::tribology
