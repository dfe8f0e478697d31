// Every frame of a scene, in files.
#pragma once

#include <vector>

#include "console.h"
#include "frame_record.h"
#include "headlamp/frame_maker.h"
#include "headlamp/headlamp_arguments.h"

namespace glare::tool {

/// Throws `OutputError` where the frames' files, or the record of a sequence, can't be written,
/// `MemoryError` where not even one frame has room.
void require_outputs(const std::vector<SceneFrame>& frames, const Camera& camera,
                     const HeadlampArguments& arguments);

/// Makes and writes every frame, several at a time, as many as the cores and the memory allow; of a
/// sequence it keeps a record, and to resume leaves out those that it shows to be finished.
/// `fingerprint` is that of everything but the backgrounds' files that the frames are made of.
/// Throws what `FrameMaker` throws.
void write_frames(const FrameMaker& maker, const SceneParts& parts,
                  const std::vector<SceneFrame>& frames, const std::string& fingerprint,
                  const HeadlampArguments& arguments, const Console& console);

}  // namespace glare::tool
