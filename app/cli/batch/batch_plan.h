/// \file
/// What a table of variations asks for: a row is a tree, or a scene, and the files to write of it.
#pragma once

#include "app/cli/command_line.h"
#include "core/qt/session/export/export_option.h"
#include <QByteArray>
#include <QSet>
#include <QSize>
#include <QStringList>
#include <cstdint>
#include <optional>
#include <vector>

namespace ramure::cli {

struct BatchRow
{
    std::int64_t number = 0; ///< in the table, from 1; the same in every shard
    int line = 0;            ///< of the file
    QString input;           ///< as loadInput takes it
    std::optional<std::int64_t> seed;
    QStringList sets;  ///< as --set takes them, in the order of the columns
    QStringList files; ///< below the folder, with / between the parts; one that ends in / is a folder of maps
    QString problem;   ///< why it cannot be done; empty: it can
};

struct BatchPlan
{
    QString table;  ///< its file's name without the folder, for messages
    QString folder; ///< where files go
    QSize picture{512, 512};
    ExportOptions options;        ///< levels and wind are those of files that hold them
    std::vector<BatchRow> rows;   ///< of the shard
    QSet<QString> foreignFolders; ///< into which rows of other shards write, see folderOf()
    std::size_t whole = 0;        ///< rows of the table
};

/// One of some parts of a table, of rows that follow one another.
struct Shard
{
    std::size_t index = 1, count = 1;

    [[nodiscard]] std::size_t begin(std::size_t rows) const { return rows * (index - 1) / count; }
    [[nodiscard]] std::size_t end(std::size_t rows) const { return rows * index / count; }
};

/// "2/7". Error: Invalid.
Expected<Shard> shardFrom(const QString& text);

/// \param files templates of those rows that do not name their own
/// Names of columns may have capitals. Numbers may have decimal commas where commas do not separate the
/// cells. Cells that mean nothing, and empty ones that a file would be named by, are their rows' problem.
/// Errors, with file and line: those of readCsv; Unknown (a column), Invalid (neither input nor preset, a
/// file that two rows would write, one outside of the folder, one that has an unknown ending, a name that is
/// no UTF-8).
Expected<BatchPlan> readPlan(const QString& table, const QStringList& files, const Shard& shard);

/// A file of a row, and those beside it whose names follow from it: no other row may write these.
QStringList ownNames(const QString& file, WindProfile wind);
/// "a/b" of "a/b/tree.obj" and of the folder of maps "a/b/"; empty of "tree.obj".
QString folderOf(const QString& file);
/// Is it a name below the folder of the batch, and none of the program's own?
bool isBelowFolder(const QString& file);

/// What the row's files depend on, as a SHA-256 in hexadecimal digits: its values, the bytes of its input
/// where that is a file, the version of the program.
QByteArray inputsHash(const BatchPlan& plan, const BatchRow& row);

} // namespace ramure::cli
