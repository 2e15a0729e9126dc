// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_hdf5_handle_h
#define squeal_base_hdf5_handle_h

#include <hdf5.h>

namespace squeal
{
  /** An HDF5 object that is closed at the end of its life. */
  class Hdf5Handle
  {
  public:
    Hdf5Handle(const hid_t id, herr_t (*close)(hid_t))
      : id(id)
      , close(close)
    {
    }
    ~Hdf5Handle()
    {
      if (id >= 0)
        close(id);
    }
    Hdf5Handle(const Hdf5Handle &)            = delete;
    Hdf5Handle &operator=(const Hdf5Handle &) = delete;

    operator hid_t() const
    {
      return id;
    }

    bool
    is_valid() const
    {
      return id >= 0;
    }

  private:
    hid_t id;
    herr_t (*close)(hid_t);
  };

  /** Keeps HDF5 from printing what the exceptions say. */
  class Hdf5Silence
  {
  public:
    Hdf5Silence()
    {
      H5Eget_auto2(H5E_DEFAULT, &function, &data);
      H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    }
    ~Hdf5Silence()
    {
      H5Eset_auto2(H5E_DEFAULT, function, data);
    }
    Hdf5Silence(const Hdf5Silence &)            = delete;
    Hdf5Silence &operator=(const Hdf5Silence &) = delete;

  private:
    H5E_auto2_t function;
    void       *data;
  };
} // namespace squeal

#endif
