#include "widgets/panels/properties/properties_panel.h"

#include "core/params/param_relevance.h"
#include "core/presets/presets.h"
#include "core/qt/document/commands.h"
#include "core/qt/session/motion/auto_key.h"
#include "core/qt/session/motion/player.h"
#include "widgets/base/fields/key_button.h"
#include "widgets/base/named.h"
#include "widgets/base/targets.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/theme/icons.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/panels/properties/grammar/generations_view.h"
#include "widgets/panels/properties/group_section.h"
#include "widgets/panels/properties/leaf_dialog.h"
#include "widgets/panels/properties/param_row.h"
#include "widgets/panels/properties/stem_curves.h"
#include "widgets/panels/properties/step_form.h"
#include "widgets/panels/properties/surface_preview.h"
#include <QClipboard>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <string_view>

namespace ramure {
namespace {

constexpr int longestLabel = 20; ///< characters of average width

} // namespace

PropertiesPanel::PropertiesPanel(Document* document, Preferences* preferences, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_preferences(preferences)
{
    setObjectName(QStringLiteral("propertiesPanel"));
    auto* layout = layoutOf<QVBoxLayout>(this, 0);

    auto* head = new QWidget(this);
    auto* headLayout = layoutOf<QVBoxLayout>(head, 6, {12, 8, 8, 8});
    m_title = named(new QLabel(head), "panelTitle");
    m_title->setTextFormat(Qt::PlainText);
    m_search = new QLineEdit(head);
    m_search->setClearButtonEnabled(true);
    m_search->setPlaceholderText(tr("Search parameters"));
    m_search->setAccessibleName(tr("Search parameters"));
    m_search->addAction(icon("search"), QLineEdit::LeadingPosition);
    m_problem = named(new QLabel(head), "problem");
    m_problem->setWordWrap(true);
    m_problem->hide();
    headLayout->addWidget(m_title);
    headLayout->addWidget(m_search);
    headLayout->addWidget(m_problem);
    layout->addWidget(head);

    m_scroll = new QScrollArea(this);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setWidgetResizable(true);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setFocusPolicy(Qt::NoFocus);
    m_scroll->setAccessibleName(tr("Parameters"));
    m_content = named(new QWidget(m_scroll), "propertiesContent");
    m_scroll->setWidget(m_content);
    buildEmpty();
    layout->addWidget(m_empty);
    layout->addWidget(m_clear, 0, Qt::AlignHCenter);
    layout->addWidget(m_scroll, 1);
    layout->addStretch();
    buildRows();
    connect(m_search, &QLineEdit::textChanged, this, [this] {
        applyFilter();
        m_scroll->verticalScrollBar()->setValue(0); // what was found stands first
    });
    connect(m_search, &QLineEdit::returnPressed, this, &PropertiesPanel::focusFirstFound);
    connect(m_document, &Document::changed, this, &PropertiesPanel::follow);
    connect(m_preferences, &Preferences::changed, this, &PropertiesPanel::applyPreferences);
    applyPreferences();
    takeTargets();
}

/// What stands in the place of the parameters where there are none.
void PropertiesPanel::buildEmpty()
{
    m_empty = named(new QLabel(this), "hint");
    m_empty->setAlignment(Qt::AlignHCenter | Qt::AlignTop);
    m_empty->setWordWrap(true);
    m_empty->setContentsMargins(24, 32, 24, 24);
    m_clear = named(new QPushButton(tr("Clear the search"), this), "clearSearch");
    m_clear->setFocusPolicy(Qt::TabFocus); // it hides when it is pressed: the focus would go anywhere
    connect(m_clear, &QPushButton::clicked, m_search, &QLineEdit::clear);
}

void PropertiesPanel::buildRows()
{
    auto* layout = layoutOf<QVBoxLayout>(m_content, 0);
    m_step = new StepForm(m_document, m_content);
    layout->addWidget(m_step);
    for (const ParamDef& def : paramTable()) {
        const auto sameGroup = [&](const GroupSection* s) {
            return std::string_view(s->group()) == def.group;
        };
        auto found = std::ranges::find_if(m_sections, sameGroup);
        if (found == m_sections.end()) {
            auto* section = new GroupSection(def.group, m_content);
            layout->addWidget(section);
            connect(section, &GroupSection::copyRequested, this, [this, section] { copyGroup(section); });
            connect(section, &GroupSection::pasteRequested, this, [this, section] { pasteGroup(section); });
            connect(section, &GroupSection::resetRequested, this, [this, section] { resetGroup(section); });
            connect(section, &GroupSection::foldedChanged, this, [this] {
                QStringList folded;
                for (const GroupSection* each : m_sections) {
                    if (each->isFolded())
                        folded += QString::fromLatin1(each->group());
                }
                m_preferences->foldedGroups.set(folded);
                updateGeometry();
            });
            found = m_sections.insert(m_sections.end(), section);
        }
        auto* row = new ParamRow(def, m_content);
        (*found)->addRow(row);
        m_rows.push_back(row);
        connect(row->editor(), &ParamEditor::valueEdited, this,
                [this, row](const ParamValue& value, GestureId gesture) { setValue(row, value, gesture); });
        connect(row->editor(), &ParamEditor::componentEdited, this,
                [this, row](int axis, double value, GestureId gesture) {
                    setComponent(row, axis, value, gesture);
                });
        connect(row, &ParamRow::resetRequested, this, [this, row] { resetRow(row); });
        connect(row, &ParamRow::menuRequested, this, [this, row](const QPoint& at) { showMenu(row, at); });
    }
    m_generations = new GenerationsView(m_document, m_content);
    row(*findParam("grammar.rules"))->addBelow(m_generations);
    m_leaf = new SurfacePreview(m_document, SurfacePreview::Surface::Leaf, m_content);
    row(*findParam("foliage.leaf"))->addBelow(m_leaf);
    connect(m_leaf, &SurfacePreview::largerRequested, this, &PropertiesPanel::showLeaf);
    m_fruit = new SurfacePreview(m_document, SurfacePreview::Surface::Fruit, m_content);
    row(*findParam("foliage.fruit"))->addBelow(m_fruit);
    m_bark = new SurfacePreview(m_document, SurfacePreview::Surface::Bark, m_content);
    row(*findParam("bark.family"))->addBelow(m_bark);
    m_object = new SurfacePreview(m_document, SurfacePreview::Surface::Object, m_content);
    row(*findParam("surface.colourPicture"))->addBelow(m_object);
    const auto drawBelow = [this](const char* key, std::optional<std::size_t> level) {
        m_curves.push_back(new StemCurves(m_document, level, m_content));
        row(*findParam(key))->addBelow(m_curves.back());
    };
    drawBelow("weberPenn.shape", std::nullopt);
    for (std::size_t i = 0; i < weberPennLevels; ++i)
        drawBelow(("weberPenn.level" + std::to_string(i) + ".taper").c_str(), i);
    layout->addStretch(1);
}

ParamRow* PropertiesPanel::row(const ParamDef& def) const
{
    return m_rows[paramId(def)];
}

void PropertiesPanel::follow(const Change& change)
{
    if (change.has(changeReset | changeSelection | changeStructure | changeNodeState)) {
        takeTargets();
        return;
    }
    const bool mine = change.nodes.empty() || std::ranges::any_of(change.nodes, [this](NodeId id) {
                          return std::ranges::count(m_nodes, id) > 0;
                      });
    if (!mine)
        return;
    if (change.has(changeParams))
        showValues(change.params);
    if (change.has(changeTracks)) { // of parameters, and of the placement
        std::vector<ParamId> params = change.params;
        for (const char* key : {"tree.translation", "tree.rotation", "tree.scale"})
            params.push_back(paramId(*findParam(key)));
        showValues(params);
    }
    if (change.has(changeResults))
        showProblem();
}

void PropertiesPanel::showTitle()
{
    if (m_nodes.empty()) {
        m_title->setText(tr("Nothing selected"));
    } else if (m_nodes.size() == 1) {
        const Node* node = m_document->scene().find(m_nodes.front());
        const QString name = QString::fromStdString(node->name);
        m_title->setText(node->locked ? tr("%1 (locked)").arg(name) : name);
    } else {
        m_title->setText(tr("%n node(s) selected", nullptr, static_cast<int>(m_nodes.size())));
    }
}

void PropertiesPanel::takeTargets()
{
    std::vector<NodeId> nodes = targetNodes(*m_document);
    std::erase_if(nodes, [this](NodeId id) { return !m_document->scene().find(id); });
    m_kinds = 0;
    m_presets.clear();
    bool locked = false;
    for (const NodeId id : nodes) {
        const Node* node = m_document->scene().find(id);
        m_presets.push_back(node->preset);
        m_kinds = static_cast<KindBits>(m_kinds | kindBit(node->kind));
        locked = locked || node->locked;
    }
    m_nodes = std::move(nodes);
    m_content->setEnabled(!locked);
    const NodeId only = m_nodes.size() == 1 ? m_nodes.front() : noNode;
    m_generations->setTree(only);
    for (SurfacePreview* preview : {m_leaf, m_fruit, m_bark, m_object})
        preview->setNode(only);
    for (StemCurves* curves : m_curves)
        curves->setNode(only);
    if (m_largeLeaf && only != noNode)
        m_largeLeaf->setTree(only);
    showValues({});
    showProblem();
    showTitle();
    applyFilter();
    alignLabels();
    updateGeometry();
}

std::vector<ParamValue> PropertiesPanel::valuesOf(const ParamDef& def) const
{
    std::vector<ParamValue> values;
    values.reserve(m_nodes.size());
    for (const NodeId id : m_nodes)
        values.push_back(m_keys ? m_keys->value(id, def) : def.get(m_document->scene().find(id)->params));
    return values;
}

void PropertiesPanel::showRow(ParamRow* row)
{
    row->showValues(valuesOf(row->def()), m_presets);
}

void PropertiesPanel::showValues(const std::vector<ParamId>& params)
{
    if (m_nodes.empty())
        return;
    for (const ParamDef& def : paramTable()) {
        const ParamId id = paramId(def);
        if (params.empty() || std::ranges::count(params, id) > 0)
            showRow(m_rows[id]);
        if (m_keys)
            m_rows[id]->showKeyState(m_keys->state(m_nodes, def));
    }
    for (GroupSection* section : m_sections)
        section->updateHeading();
    showRelevance();
}

/// Parameters that cannot act on the nodes are not offered. One that their choices do not use (the radius of
/// a box) is hidden. One that a number or a switch turns off is grey, so that no row moves while the number
/// is dragged. An edit is made to all nodes, so it must act on all of them.
void PropertiesPanel::showRelevance()
{
    const auto all = [this](const ParamDef& def, bool (*rule)(const NodeParams&, const ParamDef&)) {
        return std::ranges::all_of(
            m_nodes, [&](NodeId id) { return rule(m_document->scene().find(id)->params, def); });
    };
    bool changed = false;
    for (ParamRow* row : m_rows) {
        const bool relevant = all(row->def(), &isRelevant);
        changed = changed || relevant != row->isRelevant();
        row->setRelevant(relevant);
        row->setActs(all(row->def(), &ramure::acts));
    }
    if (changed)
        applyFilter();
    if (!m_nodes.empty())
        for (const char* key : {"grammar.axiom", "grammar.rules", "grammar.constants"})
            row(*findParam(key))
                ->editor()
                ->showGrammar(m_document->scene().find(m_nodes.front())->params.grammar);
}

void PropertiesPanel::setKeys(AutoKey* keys)
{
    m_keys = keys;
    connect(keys, &AutoKey::changed, this, [this] { showValues({}); });
    connect(keys->player(), &Player::frameChanged, this, &PropertiesPanel::showKeys);
    for (ParamRow* row : m_rows)
        connect(row, &ParamRow::keyToggled, this, [this, row] {
            const KeyState before = m_keys->state(m_nodes, row->def());
            const auto done = m_keys->toggle(m_nodes, row->def());
            report(row, done);
            if (done)
                emit messageRaised(
                    keyToggledText(coreText(row->def().label), before, m_keys->player()->frame()));
        });
    showValues({});
    for (ParamRow* row : m_rows)
        row->showKeyState(KeyState::None); // also while nothing is selected: the labels' width counts
    showValues({});
    alignLabels();
}

/// At another frame only what has keys looks different.
void PropertiesPanel::showKeys()
{
    for (ParamRow* row : m_rows)
        if (row->keyButton() && m_keys->state(m_nodes, row->def()) != KeyState::None) {
            showRow(row);
            row->showKeyState(m_keys->state(m_nodes, row->def()));
        }
}

void PropertiesPanel::showProblem()
{
    std::optional<Error> error;
    for (const NodeId id : m_nodes) {
        if (const Error* problem = m_document->problem(id)) {
            error = *problem;
            break;
        }
    }
    const ParamDef* culprit = error ? findParam(error->path) : nullptr;
    for (ParamRow* row : m_rows)
        row->showProblem(culprit == &row->def() ? error : std::nullopt);
    m_problem->setVisible(error && !culprit);
    if (error && !culprit)
        m_problem->setText(errorTextWithPlace(*error));
}

void PropertiesPanel::applyFilter()
{
    const QStringList words = searchWords();
    int shown = 0;
    for (GroupSection* section : m_sections)
        shown += section->filter(m_kinds, words);
    std::vector<GroupSection*> order = m_sections;
    std::stable_partition(order.begin(), order.end(), std::mem_fn(&GroupSection::isFoundByName));
    auto* layout = static_cast<QVBoxLayout*>(m_content->layout());
    for (int place = 0; place < static_cast<int>(order.size()); ++place)
        if (layout->indexOf(order[std::size_t(place)]) != place + 1) // below the step
            layout->insertWidget(place + 1, order[std::size_t(place)]);
    m_scroll->setVisible(m_kinds != 0 && shown > 0);
    m_empty->setVisible(m_kinds == 0 || shown == 0);
    m_clear->setVisible(m_kinds != 0 && shown == 0);
    m_empty->setText(m_kinds == 0
                         ? tr("Select a tree in the scene or in the view to change it.")
                         : tr("No parameter of the selection is called “%1”.").arg(m_search->text()));
}

void PropertiesPanel::applyPreferences()
{
    m_step->setAngleUnit(m_preferences->angleUnit());
    for (ParamRow* row : m_rows)
        row->setAngleUnit(m_preferences->angleUnit());
    const QStringList folded = m_preferences->foldedGroups();
    for (GroupSection* section : m_sections)
        section->setFolded(folded.contains(QString::fromLatin1(section->group())));
}

/// Nothing where the parameter is to be set as any other. \param axis of the value that is meant; -1: all
std::optional<Expected<void>> PropertiesPanel::editedItsOwnWay(const ParamDef& def, const ParamValue& value,
                                                               int axis, quint64 gesture)
{
    const auto own = m_ownEdits.find(&def);
    if (m_nodes.size() != 1 || own == m_ownEdits.end())
        return std::nullopt;
    if (axis < 0)
        return own->second(m_nodes.front(), value, gesture);
    ParamValue whole = m_keys ? m_keys->value(m_nodes.front(), def)
                              : def.get(m_document->scene().find(m_nodes.front())->params);
    std::get<glm::dvec3>(whole)[axis] = std::get<double>(value);
    return own->second(m_nodes.front(), whole, gesture);
}

void PropertiesPanel::setValue(ParamRow* row, const ParamValue& value, quint64 gesture)
{
    const ParamDef& def = row->def();
    if (const auto own = editedItsOwnWay(def, value, -1, gesture))
        return report(row, *own);
    if (m_keys && m_keys->takes(m_nodes, def))
        return report(row, m_keys->set(m_nodes, def, value, std::nullopt, gesture));
    report(row, edit::setParam(*m_document, m_nodes, def, value, gesture));
}

void PropertiesPanel::setComponent(ParamRow* row, int axis, double value, quint64 gesture)
{
    const ParamDef& def = row->def();
    if (const auto own = editedItsOwnWay(def, value, axis, gesture))
        return report(row, *own);
    if (m_keys && m_keys->takes(m_nodes, def)) {
        ParamValue whole = m_keys->value(m_nodes.front(), def);
        std::get<glm::dvec3>(whole)[axis] = value;
        return report(row, m_keys->set(m_nodes, def, whole, axis, gesture));
    }
    report(row, edit::setComponent(*m_document, m_nodes, def, axis, value, gesture));
}

void PropertiesPanel::report(ParamRow* row, const Expected<void>& done)
{
    if (done)
        return;
    showRow(row);
    row->showRefusal(errorText(done.error()));
}

/// Trees of several presets may each get another value, which no one edit can say.
void PropertiesPanel::resetRow(ParamRow* row)
{
    std::vector<ParamValue> standards;
    for (const std::string& preset : m_presets)
        standards.push_back(presetValue(preset, row->def()));
    if (const auto common = commonValue(standards))
        return setValue(row, *common, 0);
    const QString text = tr("Reset %1").arg(coreText(row->def().label));
    report(row, edit::resetParams(*m_document, m_nodes, {&row->def()}, text));
}

void PropertiesPanel::showMenu(ParamRow* row, const QPoint& at)
{
    if (m_nodes.empty())
        return;
    auto* menu = named(new QMenu(this), "rowMenu");
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(icon("reset"), row->resetButton()->toolTip(), row, &ParamRow::resetRequested)
        ->setEnabled(row->isChanged() && row->acts());
    menu->addSeparator();
    menu->addAction(icon("copy"), tr("Copy value"), this, [this, row] { copyRow(row); });
    menu->addAction(icon("paste"), tr("Paste value"), this, [this, row] { pasteRow(row); })
        ->setEnabled(row->acts());
    menu->addAction(tr("Copy as --set for the command line"), this, [this, row] {
        QGuiApplication::clipboard()->setText(settingText(row->def(), valuesOf(row->def()).back()));
    });
    if (m_keys && row->keyButton()) {
        menu->addSeparator();
        const bool isHere = m_keys->state(m_nodes, row->def()) == KeyState::Here;
        menu->addAction(row->keyButton()->icon(), isHere ? tr("Take the key away") : tr("Insert a key"), row,
                        &ParamRow::keyToggled)
            ->setEnabled(row->acts());
    }
    menu->popup(at);
}

/// In a window beside the panel, which stays usable.
void PropertiesPanel::showLeaf()
{
    if (m_nodes.size() != 1)
        return;
    if (!m_largeLeaf) {
        m_largeLeaf = new LeafDialog(m_document, window());
        m_largeLeaf->move(window()->mapToGlobal(QPoint(40, 110))); // the properties stay free
    }
    m_largeLeaf->setTree(m_nodes.front());
    m_largeLeaf->show();
    m_largeLeaf->raise();
    m_largeLeaf->activateWindow();
}

/// Of the active node: the last one selected.
void PropertiesPanel::copyRow(const ParamRow* row)
{
    copyValue(row->def(), valuesOf(row->def()).back());
}

void PropertiesPanel::pasteRow(ParamRow* row)
{
    const auto value = pastedValue(row->def(), m_preferences->angleUnit());
    if (value)
        setValue(row, *value, 0);
    else
        row->showRefusal(errorText(value.error()));
}

void PropertiesPanel::copyGroup(const GroupSection* section)
{
    if (m_nodes.empty())
        return;
    // The active node's values: the last one selected.
    const Node* node = m_document->scene().find(m_nodes.back());
    ParamList values;
    for (const ParamRow* row : section->rowsInReach())
        if (hasParam(node->kind, row->def()))
            values.emplace_back(&row->def(), row->def().get(node->params));
    QGuiApplication::clipboard()->setText(writeParamList(values));
}

void PropertiesPanel::pasteGroup(const GroupSection* section)
{
    auto values = readParamList(QGuiApplication::clipboard()->text());
    if (!values) {
        section->rows().front()->showRefusal(errorText(values.error()));
        return;
    }
    const std::vector<ParamRow*> rows = section->rowsInReach();
    std::erase_if(*values, [&](const auto& entry) {
        return std::ranges::count(rows, row(*entry.first)) == 0 || (entry.first->kinds & m_kinds) != m_kinds;
    });
    report(section,
           edit::setParams(*m_document, m_nodes, *values, tr("Paste %1").arg(coreText(section->group()))));
}

void PropertiesPanel::resetGroup(const GroupSection* section)
{
    std::vector<const ParamDef*> params;
    for (const ParamRow* row : section->rowsInReach()) {
        if ((row->def().kinds & m_kinds) == m_kinds)
            params.push_back(&row->def());
    }
    report(section,
           edit::resetParams(*m_document, m_nodes, params, tr("Reset %1").arg(coreText(section->group()))));
}

/// Where the parameter at fault stands.
void PropertiesPanel::report(const GroupSection* section, const Expected<void>& done)
{
    if (!done) {
        const ParamDef* culprit = findParam(done.error().path);
        (culprit ? row(*culprit) : section->rows().front())->showRefusal(errorText(done.error()));
    }
}

void PropertiesPanel::focusSearch()
{
    m_search->setFocus(Qt::ShortcutFocusReason);
    m_search->selectAll();
}

/// To the first parameter in sight, its value marked: the next key replaces it.
void PropertiesPanel::focusFirstFound()
{
    const QStringList words = searchWords();
    for (const bool byName : {true, false})
        for (const ParamRow* row : m_rows) {
            if (!row->isVisibleTo(this) || !row->editor()->isEnabled() || (byName && !row->isCalled(words)))
                continue;
            m_scroll->ensureWidgetVisible(row->editor());
            row->editor()->setFocus(Qt::TabFocusReason);
            return;
        }
}

void PropertiesPanel::showParam(const QString& key)
{
    const ParamDef* def = findParam(key.toStdString());
    if (!def || paramId(*def) >= m_rows.size() || !row(*def)->isRelevant()) // steps have their own form
        return;
    m_search->clear();
    for (GroupSection* section : m_sections) {
        if (std::ranges::count(section->rows(), row(*def)) > 0)
            section->setFolded(false);
    }
    if (row(*def)->isHidden()) // an advanced one: a search shows it
        m_search->setText(key);
    m_scroll->ensureWidgetVisible(row(*def));
    row(*def)->editor()->setFocus(Qt::ShortcutFocusReason);
}

QSize PropertiesPanel::minimumSizeHint() const
{
    // What scrolls only up and down must not be cut at the side.
    constexpr int leastHeight = 160;
    const int bar = style()->pixelMetric(QStyle::PM_ScrollBarExtent, nullptr, this);
    return {std::max(m_content->minimumSizeHint().width() + bar, QWidget::minimumSizeHint().width()),
            leastHeight};
}

void PropertiesPanel::alignLabels()
{
    // The longest names are broken into two lines rather than starving the sliders.
    int width = 0;
    for (const ParamRow* row : m_rows)
        width = std::max(width, row->labelWidth());
    width = std::min(width, fontMetrics().averageCharWidth() * longestLabel);
    for (ParamRow* row : m_rows)
        row->setLabelWidth(width);
}

} // namespace ramure
