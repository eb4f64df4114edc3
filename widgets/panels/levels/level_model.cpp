#include "widgets/panels/levels/level_model.h"

#include <QLocale>
#include <QStringList>
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

std::int64_t facesOf(const std::shared_ptr<const TriangleMesh>& mesh)
{
    return mesh ? mesh->faceCount() : 0;
}

QString percentText(double share)
{
    const double percent = 100.0 * share;
    const int decimals = percent >= 10.0 || percent == 0.0 ? 0 : percent >= 1.0 ? 1 : 2;
    if (percent > 0.0 && percent < 0.01)
        return QStringLiteral("< ") + percentText(0.0001);
    return LevelModel::tr("%1 %", "a share").arg(QLocale().toString(percent, 'f', decimals));
}

std::size_t leavesOf(const std::shared_ptr<const Foliage>& foliage)
{
    return foliage ? leafCount(*foliage) : 0;
}

} // namespace

QString metresText(double metres)
{
    return LevelModel::tr("%1 m", "metres")
        .arg(QLocale().toString(metres, 'f', metres > 0.0 && metres < 20.0 ? 1 : 0));
}

QString countText(std::int64_t count)
{
    return QLocale().toString(qlonglong(count));
}

LevelModel::LevelModel(QObject* parent)
    : QAbstractTableModel(parent)
{
}

void LevelModel::setLevels(std::shared_ptr<const TreeLevels> levels)
{
    if (levels == m_levels)
        return;
    beginResetModel();
    m_levels = std::move(levels);
    endResetModel();
}

int LevelModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() || !m_levels ? 0 : static_cast<int>(m_levels->levels.size());
}

int LevelModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : Columns;
}

QString LevelModel::cell(std::size_t row, int column) const
{
    const TreeLevel& level = m_levels->levels[row];
    const std::size_t all = leavesOf(m_levels->whole.foliage);
    if (level.billboard && (column == Bark || column == Leaves || column == LeavesLeft))
        return QStringLiteral("–");
    switch (column) {
    case Level:
        return QString::number(row);
    case Triangles:
        return countText(level.triangles());
    case Bark:
        return countText(facesOf(level.bark));
    case Leaves:
        return countText(facesOf(level.leaves) + facesOf(level.apples));
    case LeavesLeft:
        return all == 0 ? QStringLiteral("–") : percentText(double(leavesOf(level.foliage)) / double(all));
    case From:
        return metresText(m_levels->switches.distances[row]);
    case Height:
        return row == 0 ? QStringLiteral("–") : percentText(m_levels->switches.shares[row]);
    default:
        return {};
    }
}

QString LevelModel::tip(std::size_t row) const
{
    const TreeLevel& level = m_levels->levels[row];
    QString text = tr("The finest level");
    if (row > 0) {
        const LevelSwitches& at = m_levels->switches;
        text = tr("Takes the place of level %1 from %2 on, where the tree has %3 of the picture's height. "
                  "The details in which they differ, %4 mm, are one pixel of a screen 1080 pixels high from "
                  "%5 on.")
                   .arg(row - 1)
                   .arg(metresText(at.distances[row]), percentText(at.shares[row]),
                        QLocale().toString(1000.0 * level.detail * m_levels->scale, 'f', 1),
                        metresText(at.unseen[row]));
    }
    text += u'\n' + tr("A GLB says that it is needed while the tree covers %1 of the screen or more "
                       "(MSFT_screencoverage).")
                        .arg(percentText(m_levels->switches.coverage[row]));
    if (level.billboard)
        text += u'\n' + tr("A billboard: crossed cards with pictures of the whole tree");
    else if (const std::size_t all = leavesOf(m_levels->whole.foliage); all > 0)
        text += u'\n' + tr("%1 of %2 leaves, %3 times as large")
                            .arg(countText(qint64(leavesOf(level.foliage))), countText(qint64(all)),
                                 QLocale().toString(level.leafScale, 'f', 2));
    return text;
}

QVariant LevelModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid() || !m_levels)
        return {};
    if (role == Qt::EditRole && isEditable(index))
        return editText(index);
    if (role == Qt::DisplayRole)
        return cell(static_cast<std::size_t>(index.row()), index.column());
    if (role == Qt::ToolTipRole)
        return tip(static_cast<std::size_t>(index.row()));
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignRight | Qt::AlignVCenter);
    return {};
}

/// A number without its unit, as the language writes it.
QString LevelModel::editText(const QModelIndex& index) const
{
    const auto row = static_cast<std::size_t>(index.row());
    const double number =
        index.column() == From ? m_levels->switches.distances[row] : 100.0 * m_levels->switches.shares[row];
    return QLocale().toString(std::round(10.0 * number) / 10.0, 'g', 10);
}

bool LevelModel::isEditable(const QModelIndex& index) const
{
    return m_levels && index.row() > 0 && (index.column() == From || index.column() == Height);
}

Qt::ItemFlags LevelModel::flags(const QModelIndex& index) const
{
    return QAbstractTableModel::flags(index) | (isEditable(index) ? Qt::ItemIsEditable : Qt::NoItemFlags);
}

bool LevelModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    bool isNumber = false;
    const QString text = value.toString().remove(u'%').remove(u'm').trimmed();
    double number = QLocale().toDouble(text, &isNumber);
    if (!isNumber)
        number = text.toDouble(&isNumber);
    if (role != Qt::EditRole || !isEditable(index) || !isNumber || text == editText(index))
        return false;
    const auto level = static_cast<std::size_t>(index.row());
    const bool isShare = index.column() == Height;
    std::vector<double> all = isShare ? m_levels->switches.shares : m_levels->switches.distances;
    all[level] = isShare ? 0.01 * number : number;
    all.erase(all.begin());
    // Of the others, what is on show.
    for (double& each : all)
        each = isShare ? std::round(1e3 * each) / 1e3 : std::round(100.0 * each) / 100.0;
    emit edited(isShare ? std::vector<double>() : all, isShare ? all : std::vector<double>());
    return true;
}

QVariant LevelModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignRight | Qt::AlignVCenter);
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole)
        return {};
    const bool isTip = role == Qt::ToolTipRole;
    switch (section) {
    case Level:
        return isTip ? tr("Number of the level, the finest first, as in the names of the export")
                     : tr("Level");
    case Triangles:
        return isTip ? tr("Triangles of bark, leaves and fruit together") : tr("Triangles");
    case Bark:
        return isTip ? tr("Triangles of the bark, which is one closed mesh") : tr("Bark");
    case Leaves:
        return isTip ? tr("Triangles of leaves and fruit") : tr("Leaves");
    case LeavesLeft:
        return isTip
                   ? tr("Share of the tree's leaves that are left; they have grown, so that the crown keeps "
                        "its area")
                   : tr("Leaves\nleft");
    case From:
        return isTip ? tr("Distance in metres from which the level takes the place of the one before, with "
                          "a vertical angle of view of 40°. Double-click one to change it.")
                     : tr("From");
    case Height:
        return isTip ? tr("Share of the picture's height that the tree has there, whatever the angle of "
                          "view. Double-click one to change it.")
                     : tr("Height");
    default:
        return {};
    }
}

QString LevelModel::text(int firstRow, int count) const
{
    QStringList lines, names;
    for (int column = 0; column < Columns; ++column)
        names += headerData(column, Qt::Horizontal, Qt::DisplayRole).toString().simplified();
    lines += names.join(u'\t');
    for (int row = firstRow; row < std::min(firstRow + count, rowCount()); ++row) {
        QStringList cells;
        for (int column = 0; column < Columns; ++column)
            cells += cell(static_cast<std::size_t>(row), column);
        lines += cells.join(u'\t');
    }
    return lines.join(u'\n') + u'\n';
}

} // namespace ramure
