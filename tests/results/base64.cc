// SPDX-License-Identifier: LGPL-2.1-or-later
// The examples of RFC 4648, and all bytes.
#include <squeal/base/base64.h>

#include "check.h"

using namespace squeal;
using namespace squeal::testing;

int
main()
{
  check(base64("").empty() && base64("f") == "Zg==" && base64("fo") == "Zm8=" &&
          base64("foo") == "Zm9v" && base64("foob") == "Zm9vYg==" &&
          base64("fooba") == "Zm9vYmE=" && base64("foobar") == "Zm9vYmFy",
        "lengths of every remainder");
  check(base64(std::string("\xff\x00\xfb\xef", 4)) == "/wD77w==",
        "bytes beyond 127 and zero");
}
