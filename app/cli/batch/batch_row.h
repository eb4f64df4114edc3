/// \file
/// One row of a batch: grown, checked and written into a folder of its own, from where its files are renamed
/// into their places.
#pragma once

#include "app/cli/batch/batch_plan.h"
#include "app/cli/batch/manifest.h"
#include "app/cli/input.h"
#include "app/cli/mesh_check.h"
#include "core/evaluate/evaluator.h"
#include "core/io/export_scene.h"
#include "core/qt/session/export/export_options.h"
#include <QJsonObject>
#include <memory>
#include <optional>

namespace ramure::cli {

class Painter;

/// Why a row has no files: "error" of its line in the manifest.
namespace row_error {
inline constexpr const char* input = "input";
inline constexpr const char* check = "check";   ///< a mesh failed its check
inline constexpr const char* memory = "memory"; ///< the limit was reached
inline constexpr const char* crash = "crash";   ///< the process ended
inline constexpr const char* output = "output"; ///< a file cannot be written
inline constexpr const char* disk = "disk";     ///< the disk is full: no other row has room either
} // namespace row_error

/// The tree or scene of a row, with its seed and its parameters. Errors: those of loadInput and
/// applySettings; Invalid (the seed of a mesh).
Expected<Input> inputOf(const BatchRow& row);

/// Makes rows, one after the other. Parts that they share (an OpenGL context) are kept.
class RowMaker
{
public:
    explicit RowMaker(const BatchPlan& plan);
    ~RowMaker();
    RowMaker(const RowMaker&) = delete;
    RowMaker& operator=(const RowMaker&) = delete;

    /// Writes the files below stagingFolder(). \returns the line of the manifest.
    QJsonObject make(const BatchRow& row);

private:
    [[nodiscard]] ExportOptions optionsFor(const QString& path) const;
    /// Their counts go into the line.
    static Expected<std::vector<CheckedMesh>> checkWhole(const Input& input, Evaluator& evaluator,
                                                         QJsonObject& line);
    Expected<std::vector<CheckedMesh>> checkLevels(EvaluatedScene& now, QJsonObject& line);
    Expected<void> write(EvaluatedScene& now, const QString& path);
    Expected<void> draw(EvaluatedScene& now, const QString& path);

    const BatchPlan& m_plan;
    std::unique_ptr<Painter> m_painter;
    std::optional<ExportScene> m_levels; ///< levels of the row, if it writes nothing else
};

/// Returns the kind of row_error for an error.
const char* rowErrorOf(const Error& error);
/// The line of a row that could not be done. \param kind of row_error
QJsonObject failedLine(const BatchPlan& plan, const BatchRow& row, const char* kind, const QString& text);
/// Returns the folder in which a row is made. It lies beside the final places of the files, so that they can
/// be renamed.
QString stagingFolder(const BatchPlan& plan, const BatchRow& row);
/// Removes what rows of the plan that were stopped have left there.
void clearStaging(const BatchPlan& plan);
void clearStaging(const BatchPlan& plan, const BatchRow& row);
/// Moves the finished files to their places; only then the row is done. Error: Io; some files may be in their
/// places.
Expected<void> placeFiles(const BatchPlan& plan, const BatchRow& row, const QJsonObject& line);
/// The names of a line's files: all that writing the row gave.
QStringList filesOf(const QJsonObject& line);
/// Removes the files of rows that have failed: files at the row's own places, files that earlier lines of the
/// row name, and folders that are empty then. Files of other rows stay: a picture that the lines of now name,
/// or one in a folder into which rows of other shards write.
void removeStale(const BatchPlan& plan, const ManifestLines& before, const ManifestLines& now);
/// True if the line has the row's values, and its files are there, byte for byte.
bool isDone(const BatchPlan& plan, const BatchRow& row, const QJsonObject& line);

} // namespace ramure::cli
