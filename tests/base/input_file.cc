// SPDX-License-Identifier: LGPL-2.1-or-later

// What is no file is refused by one line before it is opened: a pipe would keep
// the program waiting for ever, a device may have no end.
#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/base/input_file.h>
#include <squeal/base/printable_text.h>

#include <squeal/parameters/prm_tree.h>

#include <squeal/scene/matrix_import.h>
#include <squeal/scene/mesh_file.h>
#include <squeal/sweep/reduced_model.h>

#include <squeal/results/contact_history.h>
#include <squeal/results/measured_shapes.h>
#include <squeal/results/table.h>

#include "../check.h"

#include <filesystem>
#include <fstream>
#include <functional>

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

using namespace squeal;
using namespace squeal::testing;
namespace fs = std::filesystem;

namespace
{
  void
  make_socket(const std::string &name)
  {
    const int          number  = ::socket(AF_UNIX, SOCK_STREAM, 0);
    struct sockaddr_un address = {};
    address.sun_family         = AF_UNIX;
    name.copy(address.sun_path, sizeof address.sun_path - 1);
    check(::bind(number,
                 reinterpret_cast<const struct sockaddr *>(&address),
                 sizeof address) == 0,
          "made a socket");
    ::close(number);
  }



  /** Every reader of the core by name. */
  std::vector<std::pair<std::string, std::function<void(const std::string &)>>>
  readers()
  {
    return {
      {"any file", [](const std::string &f) { read_file(f); }},
      {"a parameter file", [](const std::string &f) { prm::read_prm_file(f); }},
      {"an included file",
       [](const std::string &f) {
         std::ofstream("including.prm")
           << "include " << fs::absolute(f).string() << "\n";
         prm::read_prm_file("including.prm");
       }},
      {"a mesh", [](const std::string &f) { read_gmsh_file(f); }},
      {"a matrix",
       [](const std::string &f) {
         MatrixPartParameters part;
         part.file = f;
         read_matrix(part);
       }},
      {"a table", [](const std::string &f) { read_csv(f); }},
      {"measured shapes",
       [](const std::string &f) { read_measured_shapes(f); }},
      {"a history", [](const std::string &f) { HistoryReader reader(f); }},
      {"a basis", [](const std::string &f) {
         std::string hash;
         read_reduced_model(f, hash);
       }}};
  }
} // namespace



int
main()
{
  // A reader that waits is a failure, not a test without end.
  ::alarm(60);
  for (const char *name : {"pipe", "socket"})
    fs::remove(name);
  check(::mkfifo("pipe", 0600) == 0, "made a pipe");
  make_socket("socket");
  fs::create_directory("folder");
  for (const auto &[what, read] : readers())
    for (const char *name :
         {"pipe", "socket", "folder", "/dev/zero", "/dev/null"})
      {
        const auto &action = read;
        check_throws<InputError>(
          [&]() { action(name); }, name, what + ": " + name + " is refused");
      }

  check_throws<InputError>([]() { read_file("pipe"); },
                           "cannot read 'pipe': is a pipe (FIFO), not a file",
                           "the line says what it is");
  check(input_file_fault("missing") == "no such file", "a missing file");
  std::ofstream("file") << "a\nb";
  check(input_file_fault("file").empty() && read_file("file") == "a\nb",
        "a file is read");
  std::ofstream("empty").flush();
  check(read_file("empty").empty(), "an empty one, too");
  check(read_file("/proc/self/status").find("VmRSS") != std::string::npos,
        "and one whose size the system does not know");
  fs::create_symlink("file", "link.part");
  fs::rename("link.part", "link");
  check(read_file("link") == "a\nb", "links are followed");

  check(printable_text("\u00e4 \u20ac \U0001f600\tb\n") ==
          "\u00e4 \u20ac \U0001f600\tb\n",
        "characters of any alphabet are printed");
  check(printable_text("1.\xb3 \x1b[2J \xed\xa0\x80 \xe2\x82") ==
          "1.? ?[2J ??? ??",
        "but no other bytes that a damaged file holds");
}
