// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_tribology_tiff_file_h
#define squeal_tests_tribology_tiff_file_h

#include <opencv2/core.hpp>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace squeal
{
  namespace testing
  {
    /** A page of an uncompressed TIFF. */
    struct TiffPage
    {
      cv::Mat      values;          /**< CV_8U or CV_16U */
      unsigned int photometric = 1; /**< 0: white is zero */
      unsigned int orientation = 0; /**< 0: no tag */
      unsigned int text_tag    = 0; /**< 0: no text */
      std::string  text        = {};
      cv::Mat      alpha       = {}; /**< as values; empty: none */
    };

    inline std::string
    little_endian(const std::uint32_t value, const int n)
    {
      std::string s;
      for (int i = 0; i < n; ++i)
        s += char(value >> 8 * i);
      return s;
    }

    /** The bytes of a grey TIFF with these pages. */
    inline std::string
    tiff_file(const std::vector<TiffPage> &pages)
    {
      std::string file = "II" + little_endian(42, 2) + little_endian(0, 4);
      std::size_t link = 4;
      for (const TiffPage &page : pages)
        {
          const cv::Mat       &m       = page.values;
          const int            n       = m.depth() == CV_16U ? 2 : 1;
          const std::size_t    at      = file.size();
          std::vector<cv::Mat> samples = {m};
          if (!page.alpha.empty())
            samples.push_back(page.alpha);
          const int n_samples = int(samples.size());
          for (int y = 0; y < m.rows; ++y)
            for (int x = 0; x < m.cols; ++x)
              for (const cv::Mat &s : samples)
                file += little_endian(
                  n == 2 ? s.at<ushort>(y, x) : s.at<uchar>(y, x), n);
          const std::size_t at_text = file.size();
          file += page.text;
          file += std::string(file.size() % 2, ' ');
          std::vector<std::string> entries;
          const auto               entry =
            [&](unsigned int id, int type, std::size_t count, std::size_t v) {
              entries.push_back(little_endian(id, 2) + little_endian(type, 2) +
                                little_endian(std::uint32_t(count), 4) +
                                little_endian(std::uint32_t(v), 4));
            };
          entry(256, 3, 1, m.cols);
          entry(257, 3, 1, m.rows);
          entry(258, 3, n_samples, n_samples == 2 ? 8 * n * 0x10001 : 8 * n);
          entry(259, 3, 1, 1);
          entry(262, 3, 1, page.photometric);
          entry(273, 4, 1, at);
          if (page.orientation > 0)
            entry(274, 3, 1, page.orientation);
          entry(277, 3, 1, n_samples);
          entry(278, 3, 1, m.rows);
          entry(279, 4, 1, m.total() * n * n_samples);
          if (n_samples == 2)
            entry(338, 3, 1, 2);
          if (page.text_tag > 0)
            entry(page.text_tag, 2, page.text.size(), at_text);
          file.replace(link, 4, little_endian(std::uint32_t(file.size()), 4));
          file += little_endian(std::uint32_t(entries.size()), 2);
          for (const std::string &e : entries)
            file += e;
          link = file.size();
          file += little_endian(0, 4);
        }
      return file;
    }
  } // namespace testing
} // namespace squeal

#endif
