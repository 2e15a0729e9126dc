// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/files.h>
#include <squeal/base/run_log.h>
#include <squeal/base/unknown_choice.h>
#include <squeal/results/plotter.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

namespace squeal
{
  namespace fs = std::filesystem;

  namespace
  {
    constexpr char svg_terminal[] = "svg fontscale 1.333"; // as large as PNG

    // Surfaces of many facets: 11 MB as SVG, a fortieth of that as PNG.
    constexpr std::size_t largest_svg_data = 1 << 18; // bytes

    /** A folder of its own under the system's temporary one. */
    class TemporaryFolder
    {
    public:
      TemporaryFolder()
      {
        std::error_code error;
        fs::path        base = fs::temp_directory_path(error);
        if (error)
          base = "/tmp";
        std::string name = (base / "squeal_plot_XXXXXX").string();
        if (mkdtemp(name.data()) != nullptr)
          folder = name;
      }
      ~TemporaryFolder()
      {
        std::error_code ignored;
        if (!folder.empty())
          fs::remove_all(folder, ignored);
      }
      TemporaryFolder(const TemporaryFolder &)            = delete;
      TemporaryFolder &operator=(const TemporaryFolder &) = delete;

      /** Empty if there is none. */
      fs::path folder;
    };

    /** Runs gnuplot on @p script in @p folder; what it says goes to @p said.
     * Returns whether it ended well. */
    bool
    run_gnuplot(const fs::path    &folder,
                const std::string &script,
                std::string       &said)
    {
      const fs::path script_file = folder / "script.gp";
      const fs::path said_file   = folder / "said.txt";
      {
        std::ofstream out(script_file);
        out << script;
        if (!out.flush())
          {
            said = "cannot write " + script_file.string();
            return false;
          }
      }

      const std::string                 script_name = script_file.string();
      const std::string                 said_name   = said_file.string();
      const std::array<const char *, 4> arguments   = {
          {"gnuplot", "-d", script_name.c_str(), nullptr}};
      posix_spawn_file_actions_t actions;
      posix_spawn_file_actions_init(&actions);
      posix_spawn_file_actions_addopen(
        &actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
      posix_spawn_file_actions_addopen(&actions,
                                       STDOUT_FILENO,
                                       said_name.c_str(),
                                       O_WRONLY | O_CREAT | O_TRUNC,
                                       0600);
      posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
      pid_t     process = 0;
      const int error   = posix_spawnp(&process,
                                     "gnuplot",
                                     &actions,
                                     nullptr,
                                     const_cast<char **>(arguments.data()),
                                     environ);
      posix_spawn_file_actions_destroy(&actions);
      if (error != 0)
        {
          said = "gnuplot is not installed";
          return false;
        }
      int status = 0;
      while (waitpid(process, &status, 0) < 0 && errno == EINTR)
        {
        }
      std::ifstream      in(said_file);
      std::ostringstream text;
      text << in.rdbuf();
      said = text.str();
      return WIFEXITED(status) && WEXITSTATUS(status) == 0;
    }

    /** The line of gnuplot's words that holds the complaint. */
    std::string
    complaint(const std::string &said)
    {
      std::istringstream in(said);
      std::string        last;
      for (std::string line; std::getline(in, line);)
        if (line.find_first_not_of(" ^\t") != std::string::npos)
          last = line;
      return last.empty() ? "it ended without a word" : last;
    }
  } // namespace



  Ink
  series_ink(const std::size_t k)
  {
    static const Ink inks[] = {Ink::vermillion,
                               Ink::blue,
                               Ink::green,
                               Ink::orange,
                               Ink::purple,
                               Ink::sky};
    return inks[k % 6];
  }

  std::string
  colour_code(const Ink ink)
  {
    static const std::array<const char *, 9> codes = {{"#0072b2",
                                                       "#d55e00",
                                                       "#009e73",
                                                       "#e69f00",
                                                       "#cc79a7",
                                                       "#56b4e9",
                                                       "#000000",
                                                       "#f0e442",
                                                       "#7f7f7f"}};
    return codes.at(static_cast<std::size_t>(ink));
  }



  std::string
  text_colour(const Ink ink)
  {
    switch (ink)
      {
      case Ink::orange:
        return "#8f6200";
      case Ink::sky:
        return "#1f6f9f";
      case Ink::yellow:
        return "#6f6a00";
      case Ink::grey:
        return "#595959";
      case Ink::blue:
      case Ink::vermillion:
      case Ink::green:
      case Ink::purple:
      case Ink::black:
        return colour_code(ink);
      }
    unknown_choice("ink");
  }



  std::string
  Drawing::add_data(const std::string &content)
  {
    const std::string name = "data" + std::to_string(data.size()) + ".txt";
    data.emplace_back(name, content);
    return in_quotes(name);
  }



  void
  Drawing::add(const std::string &line)
  {
    script += line + '\n';
  }



  std::string
  in_quotes(const std::string &text)
  {
    std::string result = "'";
    for (const char c : text)
      result += c == '\''   ? std::string("''")
                : c == '\n' ? std::string(" ")
                            : std::string(1, c);
    return result + "'";
  }



  std::string
  plot_number(const double value)
  {
    char text[64];
    std::snprintf(
      text, sizeof(text), "%.7g", std::isfinite(value) ? value : 0.);
    return text;
  }



  Plotter::Plotter(RunLog &log, Announce announce_svg)
    : log(log)
    , announce_svg(std::move(announce_svg))
  {
    if (!log.on_root())
      return;
    const TemporaryFolder temporary;
    std::string           said;
    // the print is reached only where the terminal exists
    for (const std::string terminal : {"pngcairo", "png"})
      if (!available && !temporary.folder.empty() &&
          run_gnuplot(
            temporary.folder, "set terminal " + terminal + "\n", said))
        {
          available    = true;
          png_terminal = terminal;
        }
    if (!available)
      log.warning("no pictures are drawn: " +
                  (said == "gnuplot is not installed"
                     ? "gnuplot is not installed (package gnuplot-nox)"
                     : "gnuplot does not work here: " + complaint(said)));
  }



  bool
  Plotter::is_available() const
  {
    return available;
  }



  bool
  Plotter::draw_as(const Drawing     &drawing,
                   const std::string &terminal,
                   const std::string &path) const
  {
    const TemporaryFolder temporary;
    AtomicFile            picture(path);
    std::string           said = "there is no temporary folder";
    bool                  done = false;
    if (!temporary.folder.empty())
      {
        for (const auto &[name, content] : drawing.data)
          std::ofstream(temporary.folder / name) << content;
        const std::string target = fs::absolute(picture.temporary()).string();
        const std::string size =
          std::to_string(drawing.width) + "," + std::to_string(drawing.height);
        const std::string font =
          in_quotes("DejaVu Sans," + plot_number(drawing.font_size));
        done = run_gnuplot(
          temporary.folder,
          "cd " + in_quotes(temporary.folder.string()) + "\nset terminal " +
            terminal + " size " + size + " font " + font + " noenhanced" +
            " background '#ffffff'\nmarker_scale = " +
            (terminal == svg_terminal ? "0.5" : "1.0") + "\nset output " +
            in_quotes(target) + '\n' + drawing.script + "\nunset output\n",
          said);
      }
    std::error_code error;
    done = done && fs::file_size(picture.temporary(), error) > 0 && !error;
    if (done)
      picture.commit();
    else
      log.warning("the picture '" + path +
                  "' is missing: gnuplot failed: " + complaint(said));
    return done;
  }



  bool
  Plotter::draw(const Drawing &drawing, const std::string &path) const
  {
    if (!available)
      return false;
    const bool  png  = draw_as(drawing, png_terminal, path + ".png");
    std::size_t size = 0;
    for (const auto &[name, content] : drawing.data)
      size += content.size();
    if (!announce_svg || size > largest_svg_data)
      return png;
    announce_svg(path + ".svg");
    return draw_as(drawing, svg_terminal, path + ".svg") && png;
  }
} // namespace squeal
