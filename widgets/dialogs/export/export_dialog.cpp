#include "widgets/dialogs/export/export_dialog.h"

#include "core/io/formats/file_format.h"
#include "core/qt/document/document.h"
#include "core/qt/session/export/exporter.h"
#include "core/qt/session/jobs/recompute.h"
#include "widgets/base/chooser.h"
#include "widgets/base/fields/level_form.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/dialogs/export/export_task.h"
#include "widgets/dialogs/export/faults_line.h"
#include "widgets/dialogs/export/kept_form.h"
#include "widgets/dialogs/export/moment_form.h"
#include "widgets/dialogs/export/option_fields.h"
#include "widgets/dialogs/export/parts_form.h"
#include "widgets/dialogs/export/print_form.h"
#include "widgets/dialogs/export/print_preparer.h"
#include "widgets/dialogs/picture_form.h"
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QStyle>
#include <QTabBar>
#include <QVBoxLayout>
#include <algorithm>

namespace ramure {

/// Of a node's name: letters without accents, digits, - and _, as every program and system takes them.
/// "Chêne pédonculé" is "Chene_pedoncule".
static QString plainFileName(QString name)
{
    name.replace(QStringLiteral("œ"), QStringLiteral("oe"))
        .replace(QStringLiteral("Œ"), QStringLiteral("Oe"));
    QString plain;
    for (const QChar letter : name.normalized(QString::NormalizationForm_KD)) {
        const bool isPlain = letter.unicode() < 128 && (letter.isLetterOrNumber() || letter == u'-');
        if (isPlain)
            plain += letter;
        else if (letter.category() != QChar::Mark_NonSpacing && !plain.isEmpty() && !plain.endsWith(u'_'))
            plain += u'_';
    }
    while (plain.endsWith(u'_'))
        plain.chop(1);
    return plain.isEmpty() ? QStringLiteral("tree") : plain;
}

ExportDialog::ExportDialog(Document* document, Recompute* recompute, Preferences* preferences,
                           Chooser* chooser, QWidget* parent, std::int64_t shownFrame)
    : QDialog(parent)
    , m_document(document)
    , m_recompute(recompute)
    , m_preferences(preferences)
    , m_chooser(chooser)
    , m_task(new ExportTask(this))
    , m_fields(new OptionFields(this))
    , m_shownFrame(shownFrame)
{
    setObjectName(QStringLiteral("exportDialog"));
    setWindowTitle(tr("Export"));
    buildForm();
    connectForms();
    connect(m_task, &ExportTask::progress, this, &ExportDialog::setProgress);
    connect(m_task, &ExportTask::finished, this, &ExportDialog::finish);
    connect(m_recompute, &Recompute::busyChanged, this, [this](bool busy) {
        if (m_waiting && !busy)
            run();
    });
    const auto& nodes = document->scene().nodes();
    QString name = QFileInfo(document->filePath()).completeBaseName();
    if (name.isEmpty())
        name = nodes.empty() ? QStringLiteral("tree")
                             : plainFileName(QString::fromStdString(nodes.front().name));
    m_path->setText(
        QDir::toNativeSeparators(QDir(preferences->lastFolder()).filePath(name + QStringLiteral(".obj"))));
    setPicturesEnabled(false);
    takeFormat();
    m_usual = settings();
    turnPage(m_use);
}

ExportDialog::~ExportDialog() = default;

void ExportDialog::connectForms()
{
    connect(m_format, &QComboBox::currentIndexChanged, this, &ExportDialog::takeFormat);
    connect(m_parts, &PartsForm::changed, this, &ExportDialog::updateWidgets);
    connect(m_fields, &OptionFields::changed, this, &ExportDialog::updateWidgets);
    connect(m_fields->of<QComboBox>("instances"), &QComboBox::currentIndexChanged, this, [this](int row) {
        // Nothing is mixed into the one mesh of a format without objects.
        if (format() && !holds(holdsObjects))
            m_parts->setFoliage(row == 1);
    });
    connect(m_path, &QLineEdit::textChanged, this, &ExportDialog::updateWidgets);
    connect(m_moments, &MomentForm::changed, this, &ExportDialog::updateWidgets);
    connect(m_pictures, &PictureForm::changed, this, &ExportDialog::updateSummary);
    for (QCheckBox* box : {m_selection, m_hidden})
        connect(box, &QCheckBox::toggled, this, &ExportDialog::updateSummary);
    connectMessage();
    connect(m_levels, &LevelForm::changed, this, &ExportDialog::updateSummary);
    connect(m_uses, &QTabBar::currentChanged, this, &ExportDialog::takeUse);
    connectPrint();
    connect(m_browse, &QPushButton::clicked, this, &ExportDialog::browse);
    connect(m_export, &QPushButton::clicked, this, &ExportDialog::startExport);
    connect(m_kept, &KeptForm::chosen, this, &ExportDialog::setSettings);
    connect(m_kept, &KeptForm::told, this, [this](const QString& text) { setMessage(text, false); });
    connect(m_faults, &FaultsLine::showRequested, this, [this](NodeId tree) {
        reject();
        emit showRequested(tree);
    });
}

/// What was wrong with the last attempt says nothing about the next one.
void ExportDialog::connectMessage()
{
    const auto forget = [this] { setMessage({}, false); };
    connect(m_format, &QComboBox::currentIndexChanged, this, forget);
    connect(m_fields, &OptionFields::changed, this, forget);
    connect(m_levels, &LevelForm::changed, this, forget);
    connect(m_parts, &PartsForm::changed, this, forget);
    for (QCheckBox* box : {m_selection, m_hidden})
        connect(box, &QCheckBox::toggled, this, forget);
    connect(m_path, &QLineEdit::textChanged, this, forget);
    connect(m_moments, &MomentForm::changed, this, forget);
    connect(m_pictures, &PictureForm::changed, this, forget);
    connect(m_print.form, &PrintForm::changed, this, forget);
}

void ExportDialog::setAnalysis(const Analysis* analysis)
{
    m_faults->setAnalysis(analysis);
    if (analysis)
        connect(analysis, &Analysis::changed, this, &ExportDialog::showFaults);
    showFaults();
}

void ExportDialog::showFaults()
{
    m_faults->look(format() && !isPrint() ? std::optional(options()) : std::nullopt);
    m_export->setText(m_faults->isAccepted() ? tr("Export anyway") : tr("Export"));
}

/// A broken mesh is written when the button is pressed a second time.
bool ExportDialog::mayExportFaults()
{
    showFaults();
    if (m_faults->mayExport())
        return true;
    showFaults();
    setMessage(tr("Export it all the same?"), false);
    return false;
}

/// Null: pictures.
static const FileFormat* formatCalled(const QString& id)
{
    for (const FileFormat* format : fileFormats())
        if (id == QLatin1String(format->id))
            return format;
    return nullptr;
}

const FileFormat* ExportDialog::format() const
{
    return formatCalled(m_format->currentData().toString());
}

bool ExportDialog::holds(int what) const
{
    return format() && (format()->holds & what);
}

QString ExportDialog::suffix() const
{
    return format() ? QString::fromLatin1(format()->ending) : m_format->currentData().toString();
}

void ExportDialog::setFormat(const QString& id)
{
    for (const ExportUse use : exportUses)
        if (m_format->findData(id) < 0 && formatsOf(use).contains(id))
            setUse(use);
    m_format->setCurrentIndex(m_format->findData(id));
}

void ExportDialog::setPicturesEnabled(bool enabled)
{
    const int tab = static_cast<int>(ExportUse::Pictures);
    m_uses->setTabEnabled(tab, enabled);
    m_uses->setTabToolTip(tab, enabled ? tipOf(ExportUse::Pictures)
                                       : tr("Pictures need a view, which this machine cannot draw"));
}

void ExportDialog::setPath(const QString& path)
{
    m_path->setText(QDir::toNativeSeparators(path));
}

QString ExportDialog::path() const
{
    return QDir::fromNativeSeparators(m_path->text().trimmed());
}

ExportPage ExportDialog::page() const
{
    return {m_use, format(), isPrint(), isClip()};
}

ExportOptions ExportDialog::options() const
{
    const ExportPage shown = page();
    ExportOptions options = m_fields->options(&shown);
    options.parts = m_parts->parts();
    if (m_selection->isChecked())
        options.nodes = m_document->selection().nodes;
    options.hidden = m_hidden->isChecked();
    if (m_use == ExportUse::Game)
        options.levels = m_levels->options();
    options.texture = options.texture && options.model == ExportModel::Mesh && holds(holdsTexture);
    options.write.ascii = format() && format()->isText;
    return options;
}

void ExportDialog::takeFormat()
{
    m_parts->setFoliage(!format() || usualParts(*format(), options().instances) == exportAll);
    const QFileInfo info(path());
    if (viewFormats().contains(info.suffix().toLower()) || findFormat(path().toStdString(), FormatUse::Write))
        setPath(info.path() + u'/' + info.completeBaseName() + u'.' + suffix());
    m_moments->setClips(holds(holdsClip));
    m_moments->setPictures(!format());
    // A picture shows what the view shows.
    if (!format() && m_shownFrame > 0 && m_moments->moment() == ExportMoment::Rest)
        m_moments->setMoment(ExportMoment::Shown);
    if (isFilmed() && !m_moments->isNumbered())
        m_moments->setMoment(ExportMoment::Turntable);
    m_pictures->setMayBeTransparent(!isFilmed());
    updateWidgets();
}

/// All that this format can have on this page. A print says itself what is written, how large and with which
/// axes.
void ExportDialog::showRows(const ExportPage& page)
{
    m_fields->show(page);
    for (const FormRow& row : m_rows) {
        const bool isShown = !row.isShown || row.isShown(page);
        row.label->setVisible(isShown);
        row.field->setVisible(isShown);
    }
}

/// Of the page on show.
QSize ExportDialog::pageHint() const
{
    for (QWidget* widget : m_page->findChildren<QWidget*>())
        widget->updateGeometry(); // a layout out of sight keeps the hints that it had
    return m_page->sizeHint();
}

/// That the largest page takes, whatever is chosen on it.
QSize ExportDialog::roomForPages()
{
    const QSignalBlocker quiet(m_moments), too(m_print.form);
    const bool isPrintWanted = m_print.form->isWanted();
    const ExportMoment moment = m_moments->moment();
    m_moments->setMoment(ExportMoment::Sequence); // has a line of fields more
    QSize room;
    for (const ExportUse use : exportUses) {
        m_print.form->setWanted(use == ExportUse::Print);
        for (const QString& id : formatsOf(use)) {
            const FileFormat* format = formatCalled(id);
            showRows({use, format, use == ExportUse::Print, format && (format->holds & holdsClip)});
            room = room.expandedTo(pageHint());
        }
    }
    m_print.form->setWanted(isPrintWanted);
    m_moments->setMoment(moment);
    updateWidgets();
    return room;
}

/// The window only grows, and not higher than the screen: there the page is scrolled, but never sideways.
void ExportDialog::makeRoom(const QSize& page)
{
    layout()->activate();
    const int wide = page.width() + style()->pixelMetric(QStyle::PM_ScrollBarExtent, nullptr, m_scroll);
    const QSize whole = QSize(wide, page.height()) + size() - m_scroll->size();
    m_scroll->setMinimumWidth(std::max(wide, m_scroll->minimumWidth()));
    const int highest = screen()->availableSize().height() * 19 / 20;
    resize(whole.boundedTo({QWIDGETSIZE_MAX, highest}).expandedTo(size()));
}

/// Opens with room for every page and a message, so that tabs and buttons stay where they are from page to
/// page.
void ExportDialog::showEvent(QShowEvent* event)
{
    if (!testAttribute(Qt::WA_Resized)) {
        const int message = layout()->spacing() + 2 * fontMetrics().lineSpacing();
        makeRoom(roomForPages() + QSize(0, message));
    }
    QDialog::showEvent(event);
}

void ExportDialog::updateWidgets()
{
    const bool running = m_waiting || m_print.isAwaited || m_task->isRunning();
    const bool lines = options().model == ExportModel::Skeleton;
    for (QWidget* widget :
         {static_cast<QWidget*>(m_format), static_cast<QWidget*>(m_path), static_cast<QWidget*>(m_browse),
          static_cast<QWidget*>(m_hidden), static_cast<QWidget*>(m_uses), static_cast<QWidget*>(m_kept),
          static_cast<QWidget*>(m_levels), static_cast<QWidget*>(m_print.form),
          static_cast<QWidget*>(m_moments), static_cast<QWidget*>(m_pictures)})
        widget->setEnabled(!running);
    m_fields->setEnabled(!running);
    m_parts->setBoxesEnabled(!running && !lines);
    m_fields->of<QComboBox>("instances")->setEnabled(!running && !lines);
    const bool mixes = format() && !isPrint() && !holds(holdsObjects) && !lines && !options().instances;
    m_parts->setMixing(mixes ? format() : nullptr);
    m_fields->of<QCheckBox>("texture")->setEnabled(!running && holds(holdsTexture) &&
                                                   options().model == ExportModel::Mesh);
    m_fields->of<QComboBox>("maps")->setEnabled(!running && options().texture);
    showRows(page());
    m_print.form->setMayPrepare(!m_recompute->isBusy());
    m_selection->setEnabled(!running && !m_document->selection().nodes.empty());
    m_export->setEnabled(!running && !path().isEmpty() && (lines || options().parts != 0));
    m_progress->setVisible(running);
    updateSummary();
    showFaults();
}

void ExportDialog::browse()
{
    const QString filter = (format()     ? coreText(format()->name)
                            : isFilmed() ? m_format->currentText()
                                         : tr("PNG pictures")) +
                           QStringLiteral(" (*.%1)").arg(suffix());
    const QString chosen = m_chooser->saveFile(tr("Export"), path(), filter, suffix());
    if (chosen.isEmpty())
        return;
    setPath(chosen);
    if (!isNumbered())
        m_mayReplace.path = path(); // the chooser has asked
}

void ExportDialog::startExport()
{
    if (QFileInfo(path()).suffix().isEmpty())
        setPath(path() + u'.' + suffix());
    if (!mayStart() || !mayReplaceFiles())
        return;
    m_progress->setValue(0);
    if (!m_recompute->isBusy() && !mayExportFaults())
        return;
    if (m_recompute->isBusy()) {
        m_waiting = true;
        setMessage(tr("Waiting until the tree is computed…"), false);
        updateWidgets();
        return;
    }
    run();
}

void ExportDialog::run()
{
    m_waiting = false;
    if (!mayExportFaults()) // they came with the result that was waited for
        return updateWidgets();
    setMessage({}, false);
    if (isPrint())
        return writePrint();
    if (isInBackground())
        return startSequence();
    ExportOptions what = options();
    double seconds = m_moments->timeSeconds();
    if (isClip()) {
        const FrameSequence frames = m_moments->frames();
        seconds = frames.timeOf(frames.first);
        for (std::int64_t i = 1; i < frames.count(); ++i)
            what.clip.push_back(frames.timeOf(frames.frame(i)));
    }
    m_task->startExport(*m_document, what, path(), seconds, m_moments->loop());
    updateWidgets();
}

bool ExportDialog::isPrint() const
{
    return format() && m_print.form->isWanted();
}

void ExportDialog::connectPrint()
{
    m_print.preparer = new PrintPreparer(
        m_document, m_print.form, [this] { return options(); }, this);
    connect(m_print.form, &PrintForm::changed, this, &ExportDialog::takeFormat);
    for (QCheckBox* box : {m_selection, m_hidden})
        connect(box, &QCheckBox::toggled, m_print.preparer, &PrintPreparer::forget);
    connect(m_print.preparer, &PrintPreparer::began, this, [this] { setMessage({}, false); });
    connect(m_print.preparer, &PrintPreparer::progress, this, &ExportDialog::setProgress);
    connect(m_print.preparer, &PrintPreparer::finished, this, &ExportDialog::takePrint);
    connect(m_recompute, &Recompute::busyChanged, this,
            [this](bool busy) { m_print.form->setMayPrepare(!busy); });
}

void ExportDialog::takePrint(const std::optional<Error>& error)
{
    const bool writes = std::exchange(m_print.isAwaited, false);
    if (error) {
        const bool isCancelled = error->code == ErrorCode::Cancelled;
        setMessage(isCancelled ? tr("Cancelled. No file was changed.") : errorText(*error), !isCancelled);
        return updateWidgets();
    }
    if (writes)
        return writePrint();
    updateWidgets();
    makeRoom(pageHint());
}

/// As it was prepared; what was not, or is being prepared, is waited for.
void ExportDialog::writePrint()
{
    if (m_task->isRunning())
        return;
    if (m_print.preparer->print()) {
        m_task->startPrint(m_print.preparer->print(), options().write, path());
    } else {
        m_print.isAwaited = true;
        if (!m_print.preparer->isRunning())
            m_print.preparer->prepare();
    }
    updateWidgets();
}

void ExportDialog::finish(const std::optional<Error>& error)
{
    updateWidgets();
    if (error && error->code == ErrorCode::Cancelled) {
        setMessage(tr("Cancelled. No file was changed."), false);
        return;
    }
    if (error) {
        setMessage(errorTextWithPlace(*error), true);
        // While it ran everything but "Cancel" was off and took no focus: Return is to try again, not to
        // leave.
        m_path->setFocus();
        return;
    }
    keepChoices();
    emit exported(path());
    accept();
}

/// For the next export.
void ExportDialog::keepChoices()
{
    m_preferences->setLastFolder(QFileInfo(path()).absolutePath());
    m_preferences->setExportSpace(m_fields->options().space);
    m_kept->storeExport(settings());
}

void ExportDialog::setProgress(double fraction)
{
    m_progress->setValue(static_cast<int>(fraction * m_progress->maximum()));
}

void ExportDialog::setMessage(const QString& text, bool isError)
{
    m_message->setObjectName(isError ? QStringLiteral("problem") : QStringLiteral("hint"));
    m_message->style()->unpolish(m_message);
    m_message->style()->polish(m_message);
    m_message->setText(text);
    m_message->setVisible(!text.isEmpty());
}

void ExportDialog::reject()
{
    if (m_waiting) {
        m_waiting = false;
        setMessage(tr("Cancelled. No file was changed."), false);
        updateWidgets();
    } else if (m_task->isRunning()) {
        m_task->cancel();
    } else if (m_print.preparer->isRunning()) {
        m_print.preparer->cancel();
    } else {
        QDialog::reject();
    }
}

void ExportDialog::done(int result)
{
    keepPages();
    QDialog::done(result);
}

} // namespace ramure
