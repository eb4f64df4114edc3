/// \file
/// A group of rows under a heading that folds them away, with a menu to copy, paste and reset the group.
#pragma once

#include "core/params/node_kind.h"
#include <QWidget>
#include <vector>

class QToolButton;
class QVBoxLayout;

namespace ramure {

class ParamRow;

class GroupSection : public QWidget
{
    Q_OBJECT
public:
    /// \param group English label of the group, as in the parameter table.
    GroupSection(const char* group, QWidget* parent);

    [[nodiscard]] const char* group() const { return m_group; }
    [[nodiscard]] const std::vector<ParamRow*>& rows() const { return m_rows; }
    /// What a command on the group acts on: while searching what was found, else all rows.
    [[nodiscard]] std::vector<ParamRow*> rowsInReach() const;
    void addRow(ParamRow* row);

    [[nodiscard]] bool isFolded() const { return m_folded; }
    void setFolded(bool folded);
    [[nodiscard]] bool showsAdvanced() const { return m_showAdvanced; }
    /// Shows the rows that the selected nodes use (ParamRow::isRelevant) and that hold all \p words. While
    /// searching, neither folds nor the "advanced" rows hide anything. Returns how many rows are shown. Those
    /// that are called so stand before those that only speak of it.
    int filter(KindBits kinds, const QStringList& words);
    /// While searching: one of the rows that are shown is called so.
    [[nodiscard]] bool isFoundByName() const;
    void updateHeading();
    /// Whether it offers to copy, paste and reset all of its rows.
    void setMenuShown(bool shown);

signals:
    void foldedChanged();
    void copyRequested();
    void pasteRequested();
    void resetRequested();

private:
    void applyVisibility();
    void buildMenu();
    void arrange();
    [[nodiscard]] bool fits(const ParamRow* row) const;

    const char* m_group;
    std::vector<ParamRow*> m_rows;
    QToolButton* m_heading = nullptr;
    QToolButton* m_menuButton = nullptr;
    QToolButton* m_advanced = nullptr;
    QWidget* m_content = nullptr;
    QVBoxLayout* m_contentLayout = nullptr;
    KindBits m_kinds = 0;
    QStringList m_words;
    bool m_folded = false;
    bool m_showAdvanced = false;
};

} // namespace ramure
