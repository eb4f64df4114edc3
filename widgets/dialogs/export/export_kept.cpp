// Settings of the export dialog that are kept: under names, of the last export, and to repeat it.
#include "core/io/formats/file_format.h"
#include "core/qt/document/document.h"
#include "widgets/base/fields/level_form.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/dialogs/export/export_dialog.h"
#include "widgets/dialogs/export/moment_form.h"
#include "widgets/dialogs/export/option_fields.h"
#include "widgets/dialogs/export/print_form.h"
#include "widgets/dialogs/picture_form.h"
#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTabBar>
#include <algorithm>

namespace ramure {

/// Before the names that users gave: nothing chosen, and the last export of this use.
enum KeptEntry { OwnRow, LastRow };

static const QString lastKey = QStringLiteral("last"), namedKey = QStringLiteral("named"),
                     pageKey = QStringLiteral("page");
static constexpr const char* ofDocument[] = {"selection", "first", "last", "step"};

static bool hasTree(const Scene& scene)
{
    return std::ranges::any_of(scene.nodes(), [](const Node& node) { return node.kind == NodeKind::Tree; });
}

QLayout* ExportDialog::buildKept()
{
    m_kept = new QComboBox(this);
    m_kept->setObjectName(QStringLiteral("exportKept"));
    m_kept->setEditable(true);
    m_kept->setInsertPolicy(QComboBox::NoInsert);
    m_kept->lineEdit()->setMaxLength(60);
    m_keep = new QPushButton(this);
    m_keep->setObjectName(QStringLiteral("exportKeep"));
    m_forget = new QPushButton(this);
    m_forget->setObjectName(QStringLiteral("exportForget"));
    for (QPushButton* button : {m_keep, m_forget})
        button->setAutoDefault(false);
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    row->addWidget(m_kept, 1);
    row->addWidget(m_keep);
    row->addWidget(m_forget);
    connect(m_kept, &QComboBox::activated, this, &ExportDialog::takeKept);
    connect(m_kept->lineEdit(), &QLineEdit::textEdited, this, &ExportDialog::updateKept);
    connect(m_keep, &QPushButton::clicked, this, &ExportDialog::keep);
    connect(m_forget, &QPushButton::clicked, this, &ExportDialog::forgetKept);
    return row;
}

/// Of the page on show.
QVariantMap ExportDialog::keptOf(const QString& group) const
{
    return m_preferences->exportSettings().value(group + u'/' + keyOf(m_use)).toMap();
}

void ExportDialog::storeKept(const QString& group, const QVariantMap& settings)
{
    QVariantMap all = m_preferences->exportSettings();
    all.insert(group + u'/' + keyOf(m_use), settings);
    m_preferences->setExportSettings(all);
}

void ExportDialog::fillKept()
{
    const QSignalBlocker quiet(m_kept);
    m_kept->clear();
    m_kept->addItem(QString());
    m_kept->addItem(tr("As the last time"));
    m_kept->addItems(keptOf(namedKey).keys());
    m_kept->setCurrentIndex(OwnRow);
    updateKept();
}

void ExportDialog::updateKept()
{
    const QString name = m_kept->currentText().trimmed();
    const bool isNamed = keptOf(namedKey).contains(name);
    m_keep->setEnabled(!name.isEmpty() && name != m_kept->itemText(LastRow));
    m_forget->setEnabled(isNamed);
    m_keep->setToolTip(m_keep->isEnabled()
                           ? tr("Keeps the choices of this page under this name")
                           : tr("Type a name first; the choices of this page are kept under it"));
    m_forget->setToolTip(isNamed ? tr("Forgets the settings of this name")
                                 : tr("No kept settings are chosen"));
}

void ExportDialog::takeKept(int row)
{
    const QString name = m_kept->itemText(row);
    const QVariantMap settings = row == LastRow ? keptOf(lastKey) : keptOf(namedKey).value(name).toMap();
    if (row == LastRow && settings.isEmpty())
        setMessage(tr("Nothing was exported from this page yet."), false);
    else if (row != OwnRow)
        setSettings(settings);
    m_kept->setCurrentIndex(row);
    updateKept();
}

void ExportDialog::keep()
{
    const QString name = m_kept->currentText().trimmed();
    QVariantMap named = keptOf(namedKey);
    named.insert(name, settings());
    storeKept(namedKey, named);
    fillKept();
    m_kept->setCurrentText(name);
    updateKept();
    setMessage(tr("Kept as “%1”.").arg(name), false);
}

void ExportDialog::forgetKept()
{
    QVariantMap named = keptOf(namedKey);
    named.remove(m_kept->currentText().trimmed());
    storeKept(namedKey, named);
    fillKept();
}

/// All that was chosen, but not where to.
QVariantMap ExportDialog::settings() const
{
    const FrameSequence frames = m_moments->range();
    QVariantMap kept = LevelForm::settingsOf(m_levels->options());
    m_fields->store(kept);
    kept.insert({{"use", keyOf(m_use)},
                 {"format", m_format->currentData()},
                 {"branches", m_branches->isChecked()},
                 {"leaves", m_leaves->isChecked()},
                 {"apples", m_apples->isChecked()},
                 {"selection", m_selection->isChecked()},
                 {"hidden", m_hidden->isChecked()},
                 {"moment", static_cast<int>(m_moments->moment())},
                 {"first", qlonglong(frames.first)},
                 {"last", qlonglong(frames.last)},
                 {"step", qlonglong(frames.step)},
                 {"turns", m_moments->turns()},
                 {"loop", m_moments->loopSeconds()},
                 {"print", m_printing->isWanted()},
                 {"width", m_pictures->pictureSize().width()},
                 {"pixels", m_pictures->pictureSize().height()},
                 {"transparent", m_pictures->isTransparent()}});
    return kept;
}

void ExportDialog::setSettings(const QVariantMap& kept)
{
    const auto number = [&](const char* key, int otherwise) {
        return kept.value(QLatin1String(key), otherwise).toInt();
    };
    const auto is = [&](const char* key) { return kept.value(QLatin1String(key)).toBool(); };
    for (const ExportUse use : exportUses)
        if (keyOf(use) == kept.value(QStringLiteral("use")).toString())
            setUse(use);
    if (const QString id = kept.value(QStringLiteral("format")).toString(); m_format->findData(id) >= 0)
        setFormat(id);
    m_fields->take(kept);
    const std::pair<QCheckBox*, const char*> boxes[] = {{m_branches, "branches"},
                                                        {m_leaves, "leaves"},
                                                        {m_apples, "apples"},
                                                        {m_selection, "selection"},
                                                        {m_hidden, "hidden"}};
    for (const auto& [box, key] : boxes)
        box->setChecked(is(key) && (box != m_selection || !m_document->selection().nodes.empty()));
    m_levels->setOptions(LevelForm::optionsIn(kept));
    if (kept.contains(QStringLiteral("space"))) { // Version 0.1 kept one text.
        ExportOptions before;
        before.space = fileSpaceIn("# " + kept.value(QStringLiteral("space")).toString().toStdString())
                           .value_or(FileSpace());
        m_fields->set(before, ofImport);
    }
    m_moments->setFrames(number("first", 0), number("last", 0), number("step", 1));
    m_moments->setTurns(number("turns", 72));
    m_moments->setLoopSeconds(kept.value(QStringLiteral("loop"), 4.0).toDouble());
    m_moments->setMoment(static_cast<ExportMoment>(std::clamp(number("moment", 0), 0, 4)));
    m_printing->setWanted(is("print"));
    m_pictures->setPictureSize({number("width", 1920), number("pixels", 1080)});
    m_pictures->setTransparent(is("transparent"));
}

/// What it had when it was left, in this dialog or the one before; else the usual. The format is that of the
/// page by now.
void ExportDialog::turnPage(ExportUse use)
{
    if (const auto left = m_pages.find(use); left != m_pages.end())
        return setSettings(left->second);
    const QVariantMap kept = keptOf(pageKey);
    const bool isNew = kept.isEmpty();
    QVariantMap page = m_usual;
    page.remove(QStringLiteral("format"));
    page.insert(QStringLiteral("compressed"),
                use == ExportUse::Web); // what reads the web's files can unpack them
    page.insert(kept);
    page.insert(QStringLiteral("use"), keyOf(use));
    page.insert(QStringLiteral("print"), use == ExportUse::Print);
    for (const auto& [key, now] : {std::pair("width", m_pictures->pictureSize().width()),
                                   std::pair("pixels", m_pictures->pictureSize().height())})
        if (isNew || use != ExportUse::Pictures) // those of the view
            page.insert(QLatin1String(key), now);
    for (const char* key : ofDocument) // frames and nodes of another document are none of this one
        page.insert(QLatin1String(key), m_usual.value(QLatin1String(key)));
    setSettings(page);
    if (use == ExportUse::Game && (m_offered || (isNew && hasTree(m_document->scene()))))
        m_levels->setOptions(m_offered.value_or(gameLevels()));
    if (isNew)
        takeFormat(); // the parts that it usually has
}

void ExportDialog::keepPages()
{
    m_pages[m_use] = settings();
    for (const auto& [use, page] : m_pages) {
        QVariantMap all = m_preferences->exportSettings();
        all.insert(pageKey + u'/' + keyOf(use), page);
        m_preferences->setExportSettings(all);
    }
}

/// As it was, over what it wrote.
void ExportDialog::repeat(const QVariantMap& settings, const QString& path)
{
    setSettings(settings);
    setPath(path);
    m_mayReplaceAll = true;
    startExport();
}

} // namespace ramure
