// Settings of the export dialog that are kept: under names, of the last export, and to repeat it.
#include "core/io/formats/file_format.h"
#include "core/qt/document/document.h"
#include "widgets/base/fields/level_form.h"
#include "widgets/dialogs/export/export_dialog.h"
#include "widgets/dialogs/export/kept_form.h"
#include "widgets/dialogs/export/moment_form.h"
#include "widgets/dialogs/export/option_fields.h"
#include "widgets/dialogs/export/parts_form.h"
#include "widgets/dialogs/export/print_form.h"
#include "widgets/dialogs/picture_form.h"
#include <QCheckBox>
#include <QComboBox>
#include <algorithm>

namespace ramure {

static constexpr const char* ofDocument[] = {"selection", "first", "last", "step"};

static bool hasTree(const Scene& scene)
{
    return std::ranges::any_of(scene.nodes(), [](const Node& node) { return node.kind == NodeKind::Tree; });
}

/// All that was chosen, but not where to.
QVariantMap ExportDialog::settings() const
{
    const FrameSequence frames = m_moments->range();
    QVariantMap kept = LevelForm::settingsOf(m_levels->options());
    m_fields->store(kept);
    kept.insert({{"use", keyOf(m_use)},
                 {"format", m_format->currentData()},
                 {"branches", (m_parts->parts() & exportBranches) != 0},
                 {"leaves", (m_parts->parts() & exportLeaves) != 0},
                 {"apples", (m_parts->parts() & exportApples) != 0},
                 {"selection", m_selection->isChecked()},
                 {"hidden", m_hidden->isChecked()},
                 {"moment", static_cast<int>(m_moments->moment())},
                 {"first", qlonglong(frames.first)},
                 {"last", qlonglong(frames.last)},
                 {"step", qlonglong(frames.step)},
                 {"turns", m_moments->turns()},
                 {"loop", m_moments->loopSeconds()},
                 {"print", m_print.form->isWanted()},
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
    m_parts->setParts(static_cast<std::uint8_t>((is("branches") ? exportBranches : 0) |
                                                (is("leaves") ? exportLeaves : 0) |
                                                (is("apples") ? exportApples : 0)));
    m_selection->setChecked(is("selection") && !m_document->selection().nodes.empty());
    m_hidden->setChecked(is("hidden"));
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
    m_print.form->setWanted(is("print"));
    m_pictures->setPictureSize({number("width", 1920), number("pixels", 1080)});
    m_pictures->setTransparent(is("transparent"));
}

/// What it had when it was left, in this dialog or the one before; else the usual. The format is that of the
/// page by now.
void ExportDialog::turnPage(ExportUse use)
{
    if (const auto left = m_pages.find(use); left != m_pages.end())
        return setSettings(left->second);
    const QVariantMap kept = m_kept->leftPage();
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
    for (const auto& [use, page] : m_pages)
        m_kept->storePage(use, page);
}

/// As it was, over what it wrote.
void ExportDialog::repeat(const QVariantMap& settings, const QString& path)
{
    setSettings(settings);
    setPath(path);
    m_mayReplace.all = true;
    startExport();
}

} // namespace ramure
