/// \file
/// The parameters of the selected nodes, made from the parameter table: grouped, foldable, searchable.
#pragma once

#include "core/qt/document/document.h"
#include "widgets/base/texts/number_format.h"
#include "widgets/panels/properties/group_clipboard.h"
#include <QLineEdit>
#include <functional>
#include <map>
#include <optional>

class QLabel;
class QPushButton;
class QScrollArea;

namespace ramure {

class AutoKey;
class GenerationsView;
class GroupSection;
class LeafDialog;
class ParamRow;
class StemCurves;
class StepForm;
class SurfacePreview;
class Preferences;

class PropertiesPanel : public QWidget
{
    Q_OBJECT
public:
    /// Neither is owned; both must outlive the panel.
    PropertiesPanel(Document* document, Preferences* preferences, QWidget* parent = nullptr);

    /// The row of a parameter; every row of the table has one.
    [[nodiscard]] ParamRow* row(const ParamDef& def) const;
    [[nodiscard]] const std::vector<NodeId>& nodes() const { return m_nodes; }
    /// Gives buttons to parameters that may have keys, and lets fields show the values at the frame on show.
    /// Not owned.
    void setKeys(AutoKey* keys);
    /// Replaces the setting of one node's parameter by another edit; returns nothing to set the parameter as
    /// usual.
    using OwnEdit = std::function<std::optional<Expected<void>>(NodeId, const ParamValue&, quint64 gesture)>;
    void setOwnEdit(const ParamDef& def, OwnEdit edit) { m_ownEdits[&def] = std::move(edit); }
    /// The values of a step of a recipe, above the parameters of its tree.
    [[nodiscard]] StepForm* stepForm() const { return m_step; }
    [[nodiscard]] QSize sizeHint() const override { return {360, 640}; }
    /// Wide enough for the widest visible row.
    [[nodiscard]] QSize minimumSizeHint() const override;

public slots:
    void focusSearch();
    /// Shows all parameters again.
    void clearSearch() { m_search->clear(); }
    /// Unfolds what hides a parameter, scrolls to it and gives it the focus. Does nothing where the selected
    /// nodes do not use it.
    void showParam(const QString& key);

signals:
    void messageRaised(const QString& text);

private:
    void buildEmpty();
    void buildRows();
    void follow(const Change& change);
    void takeTargets();
    void showValues(const std::vector<ParamId>& params);
    void showRelevance();
    void showKeys();
    void showProblem();
    [[nodiscard]] QStringList searchWords() const
    {
        return m_search->text().toLower().split(u' ', Qt::SkipEmptyParts);
    }
    void applyFilter();
    void applyPreferences();
    void showTitle();
    void alignLabels();
    void focusFirstFound();
    void setValue(ParamRow* row, const ParamValue& value, quint64 gesture);
    void setComponent(ParamRow* row, int axis, double value, quint64 gesture);
    [[nodiscard]] std::optional<Expected<void>> editedItsOwnWay(const ParamDef& def, const ParamValue& value,
                                                                int axis, quint64 gesture);
    void copyGroup(const GroupSection* section);
    void pasteGroup(const GroupSection* section);
    void resetGroup(const GroupSection* section);
    void report(const GroupSection* section, const Expected<void>& done);
    void report(ParamRow* row, const Expected<void>& done);
    [[nodiscard]] std::vector<ParamValue> valuesOf(const ParamDef& def) const;
    void showRow(ParamRow* row);
    void resetRow(ParamRow* row);
    void showMenu(ParamRow* row, const QPoint& at);
    void showLeaf();
    void copyRow(const ParamRow* row);
    void pasteRow(ParamRow* row);

    Document* m_document;
    Preferences* m_preferences;
    AutoKey* m_keys = nullptr;
    std::map<const ParamDef*, OwnEdit> m_ownEdits;
    std::vector<NodeId> m_nodes;
    std::vector<std::string> m_presets; ///< presets of m_nodes
    KindBits m_kinds = 0;               ///< bits of the kinds of m_nodes
    std::vector<ParamRow*> m_rows;      ///< by ParamId
    std::vector<GroupSection*> m_sections;
    QLabel* m_title = nullptr;
    QLabel* m_problem = nullptr; ///< an error that belongs to no row
    StepForm* m_step = nullptr;
    GenerationsView* m_generations = nullptr;
    std::vector<StemCurves*> m_curves;
    SurfacePreview* m_leaf = nullptr;
    SurfacePreview* m_fruit = nullptr;
    SurfacePreview* m_bark = nullptr;
    SurfacePreview* m_object = nullptr;
    LeafDialog* m_largeLeaf = nullptr; ///< once it was wished for; the window owns it
    QLabel* m_empty = nullptr;
    QPushButton* m_clear = nullptr; ///< shown if a search finds nothing
    QLineEdit* m_search = nullptr;
    QScrollArea* m_scroll = nullptr;
    QWidget* m_content = nullptr;
};

} // namespace ramure
