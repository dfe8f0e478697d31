#include "glare/aperture/eye/eye_drawing.h"

#include <algorithm>
#include <numbers>

#include "glare/aperture/eye/eyelashes.h"
#include "glare/aperture/eye/eyelids.h"
#include "glare/aperture/eye/motion.h"
#include "glare/aperture/eye/pupil.h"
#include "glare/aperture/eye/random.h"

namespace glare {

namespace {

/// Lids and lashes that may be in front of the pupil.
std::vector<Outline> covers(const EyeParameters& p, double reach_mm) {
  const Eyelids lids(p.eyelids, lid_closure_at(p, p.time_s));
  std::vector<Outline> covers = lids.outlines(reach_mm);
  const auto add = [&](const EyelashParameters& lashes, Lid lid) {
    for (const Outline& lash : eyelashes(lashes, lid, lids, p.seed))
      if (lash.right() > -reach_mm && lash.left() < reach_mm && lash.bottom() > -reach_mm &&
          lash.top() < reach_mm)
        covers.push_back(lash);
  };
  add(p.upper_lashes, Lid::upper);
  add(p.lower_lashes, Lid::lower);
  return covers;
}

}  // namespace

EyeDrawing::EyeDrawing(const EyeParameters& p, EyeView view)
    : view_(view),
      width_mm_((require_valid(p), eye_picture_width_mm(p))),
      pupil_(pupil_outline(p.pupil, p.seed, pupil_diameter_at_mm(p, p.time_s))),
      covers_(view == EyeView::pupil ? std::vector<Outline>() : covers(p, width_mm_ / 2)),
      particles_(p.particles, seed_for(p.seed, EyePart::particles), p.time_s,
                 width_mm_ / 2 * std::numbers::sqrt2),
      lens_(p.lens, seed_for(p.seed, EyePart::lens)) {}

Columns EyeDrawing::draw_pupil(const Grid& grid, int y, RowCoverage& coverage,
                               std::span<float> row) const {
  if (view_ == EyeView::eyelashes) {
    std::ranges::fill(row, 1.0f);
    return {0, grid.size};
  }
  std::ranges::fill(row, 0.0f);
  if (!pupil_.cover_row(grid, y, coverage)) return {};
  Columns open{grid.size, 0};
  coverage.paint([&](int first, int last, float share) {
    open = {std::min(open.first, first), std::max(open.last, last)};
    std::fill(row.begin() + first, row.begin() + last, share);
  });
  return open;
}

Columns EyeDrawing::draw_shapes(const Grid& grid, int y, RowCoverage& coverage,
                                std::span<float> row) const {
  const Columns open = draw_pupil(grid, y, coverage, row);
  for (const Outline& cover : covers_) {
    if (!cover.cover_row(grid, y, coverage)) continue;
    coverage.paint([&](int first, int last, float share) {
      last = std::min(last, open.last);
      for (int x = std::max(first, open.first); x < last; ++x) row[x] *= 1 - share;
    });
  }
  if (open.first >= open.last) return {};
  if (view_ != EyeView::eyelashes) particles_.draw_row(grid, y, open, row);
  return open;
}

}  // namespace glare
