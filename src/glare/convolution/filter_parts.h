// What a filter holds, and its making. Internal.
#pragma once

#include <array>
#include <complex>
#include <vector>

#include "glare/base/aligned_memory.h"
#include "glare/base/image.h"
#include "glare/base/parallel.h"
#include "glare/convolution/block_plan.h"
#include "glare/convolution/glare_filter.h"
#include "glare/convolution/plane_transform.h"

namespace glare {

/// What one thread works in: a plane transform's memory for each channel.
struct ThreadMemory {
  std::array<PlaneTransform::Workspace, 3> workspaces;
};

/// What one call works in.
struct CallMemory {
  std::array<GrowingBuffer<PlaneTransform::Complex>, 3> spectra;
  std::array<Image<float>, 3> held;  ///< `BlockPlan::held_columns`.
};

struct GlareFilter::Parts {
  PixelKernel kernel;
  int width = 0, height = 0;
  Edge edge = Edge::black;
  BlockPlan plan;
  PlaneTransform transform;
  std::array<std::vector<PlaneTransform::Complex, AlignedAllocator<PlaneTransform::Complex>>, 3>
      spectra;                    ///< Of the kernel.
  std::array<float, 3> center{};  ///< Shares of the kernel's middle, which the spectra leave out.
  std::array<float, 3> least{};   ///< What light that is added is at least.
  mutable WorkspacePool<ThreadMemory> thread_memory;
  mutable WorkspacePool<CallMemory> call_memory;
};

/// Sets the spectra, middle and least light of channel `k` from the parts' kernel.
void transform_kernel(GlareFilter::Parts& parts, std::size_t k, int threads);

}  // namespace glare
