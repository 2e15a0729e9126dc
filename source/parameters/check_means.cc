// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/input_file.h>
#include <squeal/base/state_files.h>

#include <squeal/parameters/checks.h>
#include <squeal/parameters/face_geometry.h>
#include <squeal/parameters/names.h>
#include <squeal/parameters/text.h>

#include <algorithm>

namespace squeal
{
  namespace prm
  {
    void
    refuse_entry(const std::string &section,
                 const std::string &entry,
                 const std::string &reason)
    {
      throw InputError(in_quotes(path_of(section, entry)) +
                       (starts_with(reason, ":") ? "" : " ") + reason);
    }



    const BodyParameters &
    require_body(const SceneParameters &scene,
                 const std::string     &name,
                 const std::string     &section,
                 const std::string     &entry)
    {
      std::vector<std::string> names;
      for (const BodyParameters &body : scene.bodies)
        {
          if (body.name == name)
            return body;
          names.push_back(body.name);
        }
      if (name.empty())
        refuse_entry(section,
                     entry,
                     "is empty: give one of the bodies " + join(names, ", "));
      refuse_entry(section,
                   entry,
                   "= " + in_quotes(name) + " is not one of the bodies " +
                     join(names, ", ") + did_you_mean(name, names));
    }



    void
    require_face(const BodyParameters &body,
                 const std::string    &face,
                 const std::string    &section,
                 const std::string    &entry)
    {
      if (body.shape == BodyParameters::Shape::rigid)
        {
          if (!face.empty())
            refuse_entry(section,
                         entry,
                         "= " + in_quotes(face) + ": the rigid body " +
                           in_quotes(body.name) +
                           " has no faces; leave the entry empty");
          return;
        }
      const std::vector<std::string> faces = faces_of(body.shape);
      if (body.has_mesh_file() && face.empty())
        refuse_entry(section,
                     entry,
                     "is empty: give a surface of the mesh file of "
                     "body " +
                       in_quotes(body.name));
      if (body.has_mesh_file() ||
          std::find(faces.begin(), faces.end(), face) != faces.end())
        return;
      refuse_entry(section,
                   entry,
                   (face.empty() ? "is empty" : "= " + in_quotes(face)) +
                     ": body " + in_quotes(body.name) + " has the faces " +
                     join(faces, ", ") + did_you_mean(face, faces));
    }



    void
    require_inside(const std::string &name,
                   const std::string &section,
                   const std::string &entry)
    {
      if (!name.empty() && !stays_inside(name))
        refuse_entry(section,
                     entry,
                     "= " + in_quotes(name) +
                       " leaves the output directory: give a name without "
                       "'..' and without '/' in front");
    }



    void
    require_saved_name(const std::string &name,
                       const std::string &section,
                       const std::string &entry)
    {
      require_inside(name, section, entry);
      const std::string ending = ".h5", base = name.substr(name.rfind('/') + 1);
      const bool        is_h5 =
        base.size() > ending.size() &&
        base.compare(base.size() - ending.size(), ending.size(), ending) == 0;
      if (!name.empty() && (!is_h5 || name == "contact_history.h5"))
        refuse_entry(section,
                     entry,
                     "= " + in_quotes(name) +
                       ": give the file a name of its own that ends in '.h5'");
    }



    void
    require_file(const std::string &file,
                 const std::string &section,
                 const std::string &entry,
                 const bool         is_needed)
    {
      if (file.empty() && is_needed)
        refuse_entry(section, entry, "is empty: give the name of a file");
      if (file.empty())
        return;
      const std::string fault = input_file_fault(file);
      if (!fault.empty())
        refuse_entry(section,
                     entry,
                     "= '" + file + (starts_with(fault, "is ") ? "' " : "': ") +
                       fault);
    }
  } // namespace prm
} // namespace squeal
