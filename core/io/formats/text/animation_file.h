/// \file
/// `.animation` files (SPEC B4): one line per key,
///
///     time,MODE,loc.x,loc.y,loc.z,rot.x,rot.y,rot.z,rot.w,scale.x,scale.y,scale.z
///
/// seconds, metres, Z up. Files of our own script (resources/blender) begin with a line `# ramure-animation
/// 1` and may go on: easing,back,amplitude,period, then for each of the ten channels loc, rot (x y z w),
/// scale the handles in.dt,in.dv,out.dt,out.dv. Their `# fps=24`, `# loop=5` and `# parent=NAME` are read;
/// other lines beginning with # are skipped.
#pragma once

#include "core/base/error.h"
#include "core/rig/tracks/node_animation.h"
#include <string>
#include <string_view>
#include <vector>

namespace ramure {

/// A note on something guessed or mended: an error with text, file and line.
using Note = Error;
/// Code of notes that only inform: nothing is wrong with the file.
inline constexpr ErrorCode remark = ErrorCode::Limit;

/// The meaning of CUBIC: the original reader took it for the spline of SPEC B1, Blender's exporter means its
/// easing.
enum class CubicMeaning : std::uint8_t { Automatic, Spline, Easing };

struct AnimationFile
{
    NodeAnimation animation; ///< global tracks, Y up; empty where the file has no keys
    bool ownScript = false;  ///< written by our own script
    std::size_t keyCount = 0;
    double framesPerSecond = 0.0; ///< 0: not said
    std::string parent;           ///< name of another object; empty: not said
    std::vector<Note> notes;
};

/// Automatic: the easing in files of our own script, the spline in others; the notes say which was taken.
/// Byte order mark, CRLF, blanks and empty lines are fine. Mended and noted: keys out of order or at one time
/// (the last counts), unknown modes (the spline), quaternions that are no units, an empty file. Errors, with
/// file and line: Syntax (not a number, too few columns), Invalid (not finite, a quaternion without a
/// direction, a time beyond a million seconds).
Expected<AnimationFile> parseAnimation(std::string_view text, const std::string& file,
                                       CubicMeaning cubic = CubicMeaning::Automatic);
/// The global tracks of a node as such a file, with our own header and the columns of handles: parseAnimation
/// gives the same tracks where all channels have their keys at the same times and with the same modes. Others
/// are written at the times of all keys; where they go differently between, they are sampled at
/// \p framesPerSecond. \p baked tells whether that was so.
std::string animationText(const NodeAnimation& animation, double framesPerSecond, const std::string& parent,
                          bool* baked = nullptr);

} // namespace ramure
