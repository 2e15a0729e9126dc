// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/results/table.h>
#include <squeal/tribology/damage/damage_table.h>
#include <squeal/tribology/setup/feature_columns.h>
#include <squeal/tribology/statistics/association.h>
#include <squeal/tribology/statistics/feature_place.h>
#include <squeal/tribology/statistics/feature_rows.h>
#include <squeal/tribology/statistics/pad_tables.h>
#include <squeal/tribology/statistics/sliding_of_pad.h>
#include <squeal/tribology/statistics/table_faults.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <tuple>

namespace squeal::tribology
{
  namespace
  {
    const std::vector<Table::Column> places = {
      {"x_m", Table::Type::real, "m", ""},
      {"y_m", Table::Type::real, "m", ""}};

    bool
    is_among(const std::vector<std::string> &names, const std::string &name)
    {
      return std::find(names.begin(), names.end(), name) != names.end();
    }



    std::vector<std::string>
    index_columns(const Table &table, const CorrelationParameters &p)
    {
      if (!p.indices.empty())
        return p.indices;
      std::vector<std::string> names;
      for (const std::string &name : damage_indices(table))
        if (!is_among(p.covariates, name))
          names.push_back(name);
      return names;
    }



    /** The part of its cell that a row tells about, 1 where the table does not
     * say. Pixels at a border may add up to a little more than the cell. */
    double
    coverage(const Table &table, const std::size_t row, const std::string &file)
    {
      if (!table.has_column("coverage") || table.is_missing(row, "coverage"))
        return 1.;
      const double value = table.real(row, "coverage");
      if (!(value >= 0. && value <= 1.01))
        throw InputError(file + ":" + std::to_string(row + 2) +
                         ": coverage is " + shortest_text(value) +
                         ": it is the part of a cell that was seen, from 0 to "
                         "1");
      return std::min(1., value);
    }



    GridMap
    on_grid(const ContactGrid &grid, const std::vector<double> &by_node)
    {
      GridMap map{grid.n_x(), grid.n_y(), {}};
      for (const std::size_t node : grid.order())
        map.values.push_back(by_node[node]);
      for (std::size_t i = 0; i < map.n_x; ++i)
        map.xs.push_back(grid.place(grid.order()[i])[0]);
      for (std::size_t j = 0; j < map.n_y; ++j)
        map.ys.push_back(grid.place(grid.order()[j * map.n_x])[1]);
      return map;
    }



    /** Rows of a table of features that count: those of the whole pad where
     * there are such, else all. */
    struct PadRows
    {
      std::vector<std::size_t> rows;
      bool of_pad = false; /**< placed from the centre of the pad on */
    };

    /** Throws InputError where images have not been laid on the pad: each is
     * known from its own centre on, and even one may show any part of it. */
    PadRows
    rows_of_pad(const Table &table, const std::string &file)
    {
      PadRows               all, pad;
      std::set<std::string> images;
      pad.of_pad = true;
      for (std::size_t row = 0; row < table.n_rows(); ++row)
        {
          all.rows.push_back(row);
          if (!table.has_column("image"))
            continue;
          const std::string image = table.text(row, "image");
          images.insert(image);
          if (image == "pad")
            pad.rows.push_back(row);
        }
      if (!pad.rows.empty())
        return pad;
      if (images.empty())
        return all;
      const std::string which =
        images.size() == 1
          ? "of '" + *images.begin() + "', which is not laid on the pad"
          : "of " + std::to_string(images.size()) + " images ('" +
              *images.begin() + "', '" + *std::next(images.begin()) +
              "', ...), none laid on the pad";
      throw InputError(file + ": its rows are " + which +
                       ", and places count from the centre of the image: "
                       "segment it with 'Registration', which adds rows of "
                       "the image 'pad'");
    }



    /** Rows of features on the nodal cells, with the part of each row's cell
     * that was seen. */
    struct SeenRows
    {
      std::vector<std::size_t> rows; /**< of the table */
      FeatureRows              lie;  /**< numbers of @p rows */
      std::vector<double>      coverages;
      bool is_place_assumed = false; /**< see FeaturePlace */
    };

    constexpr const char *crack_density = "crack_density_per_m";

    /** A feature on the cells: the mean of the rows of a cell, by the area of
     * it that each of them has seen, or by the length of the cracks there of
     * what is a mean along them. */
    GridMap
    feature_map(const ContactGrid &grid,
                const Table       &table,
                const SeenRows    &seen,
                const std::string &name)
    {
      const bool is_by_length =
        is_mean_along_cracks(name) && table.has_column(crack_density);
      std::vector<double> sums(grid.n_nodes(), 0.), weights(grid.n_nodes(), 0.);
      for (const FeatureRows::Share &share : seen.lie.shares)
        {
          const std::size_t row   = seen.rows[share.row];
          const double      value = table.real(row, name),
                       weight =
                         share.part * seen.coverages[share.row] *
                         (is_by_length ? table.real(row, crack_density) : 1.);
          if (std::isfinite(value) && weight > 0.)
            {
              sums[share.node] += weight * value;
              weights[share.node] += weight;
            }
        }
      for (std::size_t k = 0; k < sums.size(); ++k)
        sums[k] = weights[k] > 0. ? sums[k] / weights[k] : NAN;
      return on_grid(grid, sums);
    }



    /** The part of each cell that rows have seen. */
    std::vector<double>
    seen_parts(const ContactGrid &grid, const SeenRows &seen)
    {
      std::vector<double> parts(grid.n_nodes(), 0.);
      for (const FeatureRows::Share &share : seen.lie.shares)
        parts[share.node] += share.part * seen.coverages[share.row];
      for (double &part : parts)
        part = std::min(1., part);
      return parts;
    }



    /** Whether a cell is seen, but too little to count. */
    bool
    is_thin(const PadMaps &pad, const std::size_t cell, const double least)
    {
      const double part = pad.coverage.values[cell];
      return part > 0. && part < least;
    }



    /** A feature without the cells that are seen too little. */
    GridMap
    well_seen(const PadMaps &pad, GridMap feature, const double least)
    {
      for (std::size_t cell = 0; cell < feature.size(); ++cell)
        if (is_thin(pad, cell, least))
          feature.values[cell] = NAN;
      return feature;
    }



    /** The rows of a table of features that count, on the nodal cells about
     * @p points. */
    SeenRows
    seen_rows(const ContactGrid                        &grid,
              const std::vector<std::array<double, 3>> &points,
              const Table                              &features,
              const std::string                        &file)
    {
      auto [rows, of_pad] = rows_of_pad(features, file);
      std::vector<std::array<double, 2>> stated;
      for (const std::size_t row : rows)
        stated.push_back(
          {{features.real(row, "x_m"), features.real(row, "y_m")}});
      const FeaturePlace place = place_of_features(points, stated, of_pad);
      SeenRows           seen;
      seen.is_place_assumed = place.is_assumed;
      std::vector<std::array<double, 2>> at;
      for (const auto &from : stated)
        at.push_back({{from[0] + place.shift[0], from[1] + place.shift[1]}});
      for (const std::size_t row : rows)
        seen.coverages.push_back(coverage(features, row, file));
      seen.rows = std::move(rows);
      seen.lie  = share_rows(grid, at, [&](const std::size_t row) {
        return file + ":" + std::to_string(seen.rows[row] + 2) + ": ";
      });
      return seen;
    }



    bool
    is_any_synthetic(const Table                    &features,
                     const std::vector<std::size_t> &rows)
    {
      return features.has_column("synthetic") &&
             std::any_of(rows.begin(), rows.end(), [&](const std::size_t row) {
               return features.real(row, "synthetic") > 0.;
             });
    }



    PadMaps
    read_pad(const std::string           &damage_file,
             const std::string           &feature_file,
             const CorrelationParameters &p)
    {
      std::vector<Table::Column> needed = places;
      needed.push_back({"area_m2", Table::Type::real, "m^2", ""});
      const Table damage   = read_whole_csv(damage_file, needed);
      const Table features = read_whole_csv(feature_file, places);
      require_possible_features(features, feature_file);
      std::vector<std::array<double, 3>> points;
      for (std::size_t i = 0; i < damage.n_rows(); ++i)
        {
          points.push_back(
            {{damage.real(i, "x_m"), damage.real(i, "y_m"), 0.}});
          if (!(damage.real(i, "area_m2") > 0.))
            throw InputError(damage_file + ":" + std::to_string(i + 2) +
                             ": area_m2 is not positive");
        }
      if (points.empty())
        throw InputError("'" + damage_file + "' has no cells");
      PadMaps          pad;
      const PadSliding sliding =
        sliding_of_pad(damage, damage_file, p.leading_edge);
      pad.is_edge_assumed = sliding.is_assumed;
      pad.grid            = std::make_unique<ContactGrid>(
        points, damage.reals("area_m2"), sliding.direction);
      if (!pad.grid->is_grid())
        throw InputError(
          "'" + damage_file +
          "': its cells form no rectangular grid, which the terms of rim and "
          "edges and the surrogates need: of a sector of a ring give radius "
          "less its mean and mean radius times angle as x_m and y_m of both "
          "tables, of a round pad keep the rows of a rectangle in it "
          "(doc/theory/correlation.md, Limits)");
      for (const std::string &name : index_columns(damage, p))
        {
          damage.column_index(name);
          const GridMap map = on_grid(*pad.grid, damage.reals(name));
          if (std::all_of(map.values.begin(),
                          map.values.end(),
                          [](const double v) { return std::isfinite(v); }))
            pad.indices[name] = map;
          else if (!p.indices.empty() ||
                   std::any_of(map.values.begin(),
                               map.values.end(),
                               [](const double v) { return std::isfinite(v); }))
            throw InputError(
              "'" + damage_file + "': the index '" + name +
              "' is not known in every cell" +
              (p.indices.empty() ? ": name the others in 'Indices'" : ""));
        }
      const SeenRows rows =
        seen_rows(*pad.grid, points, features, feature_file);
      pad.coarseness           = rows.lie.coarseness;
      pad.is_place_assumed     = rows.is_place_assumed;
      std::vector<double> seen = seen_parts(*pad.grid, rows);
      pad.coverage             = on_grid(*pad.grid, seen);
      for (std::size_t k = 0; k < seen.size(); ++k)
        seen[k] *= pad.grid->area(k);
      pad.seen                  = on_grid(*pad.grid, seen);
      const auto map_of_feature = [&](const std::string &name) {
        return feature_map(*pad.grid, features, rows, name);
      };
      const std::vector<std::string> names = feature_columns(features, p);
      if (std::any_of(names.begin(), names.end(), is_mean_along_cracks) &&
          features.has_column(crack_density))
        {
          pad.crack_length = map_of_feature(crack_density);
          for (std::size_t k = 0; k < pad.crack_length.size(); ++k)
            pad.crack_length.values[k] *= pad.seen.values[k];
        }
      pad.is_synthetic = is_any_synthetic(features, rows.rows);
      pad.texts        = columns_of_texts(features, p, feature_file);
      for (const std::string &name : names)
        {
          require_finite_numbers(features, name, feature_file);
          pad.features[name] = map_of_feature(name);
        }
      pad.doubled_rows = rows_that_disagree(features, rows.rows, names);
      if (pad.features.empty() || pad.indices.empty())
        throw InputError("'" +
                         (pad.features.empty() ? feature_file : damage_file) +
                         "' has no columns to correlate");
      std::vector<MeasuredCause> measured;
      for (const std::string &name : p.covariates)
        {
          std::vector<MeasuredCause> causes;
          if (damage.has_column(name))
            {
              require_finite_numbers(damage, name, damage_file);
              causes.push_back({name, on_grid(*pad.grid, damage.reals(name))});
            }
          if (features.has_column(name))
            {
              require_finite_numbers(features, name, feature_file);
              causes.push_back({name, map_of_feature(name)});
            }
          if (causes.empty())
            throw InputError("'Covariates': neither '" + damage_file +
                             "' nor '" + feature_file + "' has a column '" +
                             name + "'");
          if (causes.size() == 2)
            {
              causes[0].name += " of the damage table";
              causes[1].name += " of the features";
            }
          for (MeasuredCause &cause : causes)
            {
              if (is_same_everywhere(cause.map))
                pad.constant_covariates.push_back(cause.name);
              measured.push_back(std::move(cause));
            }
        }
      if (pad.features.count(along_sliding_column) > 0 ||
          is_among(p.covariates, along_sliding_column))
        require_same_sliding(sliding, damage_file, features, feature_file);
      pad.causes = shared_causes(
        pad.coverage, p.shared_causes, sliding.leading_edge, measured);
      return pad;
    }
  } // namespace



  std::vector<PadMaps>
  read_pads(const CorrelationParameters &p)
  {
    std::vector<PadMaps> pads;
    for (std::size_t i = 0; i < p.damage_tables.size(); ++i)
      {
        pads.push_back(read_pad(p.damage_tables[i], p.feature_tables[i], p));
        pads.back().is_silent = !p.groups.empty() && p.groups[i] == "silent";
      }
    return pads;
  }



  std::vector<PadLink>
  link_pads(const std::vector<PadMaps> &pads, const CorrelationParameters &p)
  {
    std::vector<PadLink> links;
    std::mt19937_64      generator(p.seed);
    std::size_t          n_links = 0;
    for (const PadMaps &pad : pads)
      n_links += pad.indices.size() * pad.features.size();
    const unsigned int n_surrogates = surrogates_needed(p, n_links);
    for (std::size_t pad = 0; pad < pads.size(); ++pad)
      {
        ConditionalTests conditional(pads[pad].causes);
        // all indices of a feature in turn: its covariance is fitted once
        for (const auto &[feature, map] : pads[pad].features)
          {
            const GridMap y = well_seen(pads[pad], map, p.least_coverage);
            for (const auto &[index, x] : pads[pad].indices)
              links.push_back(
                {pad,
                 index,
                 feature,
                 measure_link(x, y, conditional, p, n_surrogates, generator)});
          }
      }
    std::sort(
      links.begin(), links.end(), [](const PadLink &a, const PadLink &b) {
        return std::tie(a.pad, a.index, a.feature) <
               std::tie(b.pad, b.index, b.feature);
      });
    std::vector<LinkTest> tests;
    for (const PadLink &link : links)
      tests.push_back(link.test);
    decide(tests, p);
    for (std::size_t i = 0; i < links.size(); ++i)
      links[i].test = tests[i];
    return links;
  }



  std::vector<std::string>
  warnings_of_thin_cells(const std::vector<PadMaps>  &pads,
                         const CorrelationParameters &p)
  {
    std::vector<std::string> warnings;
    for (std::size_t i = 0; i < pads.size(); ++i)
      {
        std::size_t n_thin = 0;
        for (std::size_t cell = 0; cell < pads[i].coverage.size(); ++cell)
          n_thin += is_thin(pads[i], cell, p.least_coverage);
        if (n_thin > 0)
          warnings.push_back(
            "pad " + std::to_string(i + 1) + ": " + std::to_string(n_thin) +
            " of " + std::to_string(pads[i].coverage.size()) +
            " cells are seen to less than 'Least coverage', " +
            rounded_text(p.least_coverage, 2) + ", and do not count in links");
      }
    return warnings;
  }
} // namespace squeal::tribology
