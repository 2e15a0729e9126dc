// SPDX-License-Identifier: LGPL-2.1-or-later

// Linked into every program of a sanitized build: modules that MPI loads stay
// until the process ends. What they keep would else be reported as a leak of an
// unknown module, which no line of leaks.supp can name.
extern "C" int
dlclose(void *)
{
  return 0;
}
