// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/checksum.h>
#include <squeal/base/files.h>
#include <squeal/base/program_id.h>

#include <cstdio>
#include <cstring>

#include <link.h>

namespace squeal
{
  namespace
  {
    std::string
    hexadecimal(const unsigned char *bytes, const std::size_t n)
    {
      std::string text;
      for (std::size_t i = 0; i < n; ++i)
        {
          char digits[3];
          std::snprintf(digits, sizeof digits, "%02x", bytes[i]);
          text += digits;
        }
      return text;
    }

    /** Sizes of parts of a note are multiples of four. */
    std::size_t
    padded(const std::size_t size)
    {
      return (size + 3) / 4 * 4;
    }

    /** The build id among the notes in @p size bytes at @p note. */
    std::string
    build_id(const char *note, const std::size_t size)
    {
      const char *const end = note + size;
      while (note + sizeof(ElfW(Nhdr)) <= end)
        {
          ElfW(Nhdr) head;
          std::memcpy(&head, note, sizeof head);
          const char *const name = note + sizeof head;
          const char *const text = name + padded(head.n_namesz);
          if (head.n_type == NT_GNU_BUILD_ID && head.n_namesz == 4 &&
              std::memcmp(name, "GNU", 4) == 0)
            return hexadecimal(reinterpret_cast<const unsigned char *>(text),
                               head.n_descsz);
          note = text + padded(head.n_descsz);
        }
      return "";
    }

    /** The program comes first among what is loaded. */
    int
    look_at_program(dl_phdr_info *info, std::size_t, void *result)
    {
      auto &id = *static_cast<std::string *>(result);
      for (unsigned int i = 0; i < info->dlpi_phnum && id.empty(); ++i)
        if (info->dlpi_phdr[i].p_type == PT_NOTE)
          id = build_id(reinterpret_cast<const char *>(
                          info->dlpi_addr + info->dlpi_phdr[i].p_vaddr),
                        info->dlpi_phdr[i].p_memsz);
      return 1;
    }

    std::string
    find_program_id()
    {
      std::string id;
      ::dl_iterate_phdr(look_at_program, &id);
      return id.empty() ? checksum_of(read_file("/proc/self/exe")) : id;
    }
  } // namespace



  std::string
  program_id()
  {
    static const std::string id = find_program_id();
    return id;
  }
} // namespace squeal
