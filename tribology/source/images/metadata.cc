// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/files.h>
#include <squeal/tribology/images/micrograph.h>
#include <squeal/tribology/images/tiff_directory.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <utility>

namespace squeal::tribology
{
  namespace
  {
    constexpr unsigned int fei_tags[]      = {34680, 34682};
    constexpr unsigned int zeiss_tag       = 34118;
    constexpr unsigned int description_tag = 270;
    // Width and height of a pixel as a text states them.
    constexpr double rounding_of_pixels = 1e-3;

    /** A number with a decimal comma, as microscopes of some countries write,
     * with a point. */
    std::string
    with_decimal_point(std::string text)
    {
      const std::size_t comma = text.find(',');
      if (comma != std::string::npos && comma > 0 && comma + 1 < text.size() &&
          std::isdigit(text[comma - 1]) && std::isdigit(text[comma + 1]) &&
          text.find('.') == std::string::npos)
        text[comma] = '.';
      return text;
    }

    /** What @p word stands for in um, @p usual where there is none; nothing of
     * a word that is no unit. */
    std::optional<double>
    unit_of_length(const std::string &word, const double usual)
    {
      const std::map<std::string, double> units = {{"", usual},
                                                   {"pm", 1e-6},
                                                   {"nm", 1e-3},
                                                   {"um", 1.},
                                                   {"\xb5m", 1.},
                                                   {"\xc2\xb5m", 1.},
                                                   {"\xce\xbcm", 1.},
                                                   {"mm", 1e3},
                                                   {"cm", 1e4},
                                                   {"m", 1e6}};
      const auto                          found = units.find(word);
      return found == units.end() ? std::nullopt
                                  : std::optional<double>(found->second);
    }

    /** What follows "@p key =" on a line of its own. */
    std::optional<std::string>
    value_of(const std::string &text, const std::string &key)
    {
      std::istringstream lines(text);
      for (std::string line; std::getline(lines, line);)
        {
          const std::size_t sign  = line.find('=');
          const std::size_t first = line.find_first_not_of(" \t");
          if (sign == std::string::npos || first == std::string::npos)
            continue;
          std::string name = line.substr(first, sign - first);
          name.erase(name.find_last_not_of(" \t") + 1);
          if (name == key)
            return with_decimal_point(line.substr(sign + 1));
        }
      return std::nullopt;
    }



    /** A number and the word behind it; nothing where there is no number. */
    std::optional<std::pair<double, std::string>>
    number_and_unit(const std::optional<std::string> &value)
    {
      if (!value)
        return std::nullopt;
      char        *end    = nullptr;
      const double number = std::strtod(value->c_str(), &end);
      if (end == value->c_str() || !std::isfinite(number))
        return std::nullopt;
      std::string unit;
      std::istringstream(end) >> unit;
      return std::pair(number, unit);
    }



    /** The number after "@p key = ", times the unit that follows it, in um;
     * @p unit (um) where the file names none. */
    std::optional<double>
    length_of(const std::string &text,
              const std::string &key,
              const double       unit)
    {
      const auto number = number_and_unit(value_of(text, key));
      if (!number)
        return std::nullopt;
      const auto factor = unit_of_length(number->second, unit);
      if (!factor)
        return std::nullopt;
      return number->first * *factor;
    }



    /** The angle after "@p key = " in degrees, whatever it is followed by;
     * @p unit: degrees of what the file counts in. 0 where there is none. */
    double
    angle_of(const std::string &text,
             const std::string &key,
             const double       unit = 1.)
    {
      const auto number = number_and_unit(value_of(text, key));
      return number ? std::remainder(number->first * unit, 360.) : 0.;
    }



    ImageMetadata
    from_keys(const std::string &text,
              const std::string &source,
              const std::string &pixel,
              const std::string &x,
              const std::string &y,
              const double       unit)
    {
      ImageMetadata m;
      m.pixel_size    = length_of(text, pixel, unit);
      const auto at_x = length_of(text, x, unit);
      const auto at_y = length_of(text, y, unit);
      if (at_x && at_y)
        m.stage = cv::Point2d(*at_x, *at_y);
      if (m.pixel_size || m.stage)
        m.source = source;
      return m;
    }



    /** Nothing where these numbers are no size of a picture. */
    std::optional<cv::Size>
    size_of(const double columns, const double rows)
    {
      constexpr double most = 1e6;
      if (!(columns >= 1. && columns <= most && rows >= 1. && rows <= most))
        return std::nullopt;
      return cv::Size(int(columns), int(rows));
    }



    /** Bytes that are no ASCII may be of any encoding and are left out. */
    std::string
    in_ascii(std::string line)
    {
      line.erase(
        std::remove_if(line.begin(),
                       line.end(),
                       [](const char c) { return c < ' ' || c > '~'; }),
        line.end());
      return line;
    }



    /** Makes the edge of a pixel of FEI tags that of a square as large as the
     * pixel, or none where its height is stated and no length. */
    void
    take_height(ImageMetadata &m, const std::string &text)
    {
      const std::string key    = "PixelHeight";
      const auto        stated = value_of(text, key);
      if (!m.pixel_size || !(*m.pixel_size > 0.) || !stated ||
          stated->find_first_not_of(" \t\r") == std::string::npos)
        return;
      const double height = length_of(text, key, 1e6).value_or(0.);
      if (!(height > 0.))
        {
          m.pixel_size.reset();
          m.without_scale = "'" + in_ascii(key + "=" + *stated) +
                            "' of its FEI tags is no length above 0, and "
                            "nothing else tells the shape of its pixels";
          return;
        }
      if (std::abs(height / *m.pixel_size - 1.) <= rounding_of_pixels)
        return;
      m.aspect     = height / *m.pixel_size;
      m.pixel_size = std::sqrt(height * *m.pixel_size);
    }



    /** FEI: pixels have a width and a height, which scans can make unequal;
     * angles are in radians. */
    ImageMetadata
    from_fei(const std::string &text)
    {
      ImageMetadata m =
        from_keys(text, "FEI tags", "PixelWidth", "StageX", "StageY", 1e6);
      take_height(m, text);
      const auto columns = number_and_unit(value_of(text, "ResolutionX"));
      const auto rows    = number_and_unit(value_of(text, "ResolutionY"));
      if (columns && rows)
        m.size = size_of(columns->first, rows->first);
      constexpr double radian = 180. / CV_PI;
      m.stage_rotation        = angle_of(text, "StageR", radian);
      m.scan_rotation         = angle_of(text, "ScanRotation", radian);
      return m;
    }



    /** Two whole numbers and a sign of multiplication: "1024 * 768". */
    std::optional<cv::Size>
    size_in(const std::optional<std::string> &value)
    {
      if (!value)
        return std::nullopt;
      int                columns, rows;
      char               sign;
      std::istringstream words(*value);
      if (!(words >> columns >> sign >> rows) || (sign != '*' && sign != 'x'))
        return std::nullopt;
      return size_of(columns, rows);
    }



    /** Zeiss: the angle of the scan stays in the file when it is off. */
    ImageMetadata
    from_zeiss(const std::string &text)
    {
      ImageMetadata m = from_keys(
        text, "Zeiss tags", "Image Pixel Size", "Stage at X", "Stage at Y", 1.);
      if (!m.pixel_size)
        m.pixel_size = length_of(text, "Pixel Size", 1.);
      if (m.pixel_size)
        m.source = "Zeiss tags";
      m.size           = size_in(value_of(text, "Store resolution"));
      m.stage_rotation = angle_of(text, "Stage at R");
      const auto state = value_of(text, "Scan Rot");
      if (!state || state->find("Off") == std::string::npos)
        m.scan_rotation = angle_of(text, "Scan Rotation");
      return m;
    }



    /** What stands behind the bar of a JEOL text, in um: a number and one word,
     * its unit, apart or not. */
    std::optional<double>
    jeol_length(const std::string &value)
    {
      const auto number = number_and_unit(with_decimal_point(value));
      const auto factor =
        number ? unit_of_length(number->second, 1.) : std::nullopt;
      return factor ? std::optional(number->first * *factor) : std::nullopt;
    }



    /** Why @p line tells no scale. */
    std::string
    no_length(const std::string &line)
    {
      return "'" + in_ascii(line) +
             "' of its JEOL text is no length in pm, nm, um, mm, cm or m";
    }



    /** The next word of a JEOL text, which is a number. */
    std::optional<double>
    next_number(std::istream &words)
    {
      std::string word;
      words >> word;
      const auto number = number_and_unit(with_decimal_point(word));
      return number ? std::optional(number->first) : std::nullopt;
    }



    /** JEOL: the bar in pixels, the length that it stands for, the size of the
     * picture in pixels, the stage in mm, the turn of the scan in degrees. */
    ImageMetadata
    from_jeol(const std::string &text)
    {
      ImageMetadata      m;
      double             bar = 0., marker = 0.;
      std::istringstream lines(text);
      for (std::string line; std::getline(lines, line);)
        {
          std::istringstream words(line);
          std::string        key;
          words >> key;
          if (key == "$$SM_MICRON_BAR")
            bar = next_number(words).value_or(0.);
          else if (key == "$$SM_MICRON_MARKER")
            {
              std::string value;
              std::getline(words, value);
              const auto length = jeol_length(value);
              marker            = length.value_or(0.);
              m.without_scale   = length ? "" : no_length(key + value);
            }
          else if (key == "$$SM_SCAN_ROTATION")
            {
              const auto angle = next_number(words);
              m.scan_rotation  = std::remainder(angle.value_or(0.), 360.);
            }
          else if (key == "$CM_FULL_SIZE")
            {
              const auto columns = next_number(words),
                         rows    = next_number(words);
              if (columns && rows)
                m.size = size_of(*columns, *rows);
            }
          else if (key == "$CM_STAGE_POS")
            {
              const auto x = next_number(words), y = next_number(words);
              if (x && y)
                m.stage = cv::Point2d(1e3 * *x, 1e3 * *y);
            }
        }
      if (bar > 0. && marker > 0.)
        m.pixel_size = marker / bar;
      if (m.pixel_size || m.stage)
        m.source = "JEOL text";
      return m;
    }



    /** Text chunk of a PNG whose key is "squeal". */
    std::string
    png_text(const std::string &data)
    {
      const std::string key   = std::string("tEXtsqueal") + '\0';
      const std::size_t place = data.find(key);
      if (place == std::string::npos || place < 4)
        return "";
      std::uint32_t length = 0;
      for (int i = 0; i < 4; ++i)
        length = 256 * length + std::uint8_t(data[place - 4 + i]);
      const std::size_t prefix = key.size() - 4;
      return length < prefix ? ""
                             : data.substr(place + key.size(), length - prefix);
    }
  } // namespace



  ImageMetadata
  read_metadata(const std::string &path)
  {
    const std::string   data = read_file(path);
    const TiffDirectory tiff(data);
    for (const unsigned int tag : fei_tags)
      {
        const ImageMetadata m = from_fei(tiff.text(tag));
        if (m.pixel_size || !m.without_scale.empty())
          return m;
      }
    const ImageMetadata zeiss = from_zeiss(tiff.text(zeiss_tag));
    if (zeiss.pixel_size)
      return zeiss;
    std::string own = png_text(data);
    if (own.empty())
      own = tiff.text(description_tag);
    ImageMetadata synthetic = from_keys(
      own, "synthetic specimen", "Pixel size", "Stage x", "Stage y", 1.);
    if (synthetic.pixel_size)
      {
        synthetic.is_synthetic =
          own.find("Kind = synthetic") != std::string::npos;
        return synthetic;
      }
    std::filesystem::path beside(path);
    beside.replace_extension(".txt");
    std::error_code error;
    if (std::filesystem::is_regular_file(beside, error))
      return from_jeol(read_file(beside.string()));
    return {};
  }
} // namespace squeal::tribology
