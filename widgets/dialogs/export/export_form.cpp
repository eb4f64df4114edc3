// The widgets of the export dialog, and what they say.
#include "core/io/formats/file_format.h"
#include "core/qt/document/document.h"
#include "widgets/base/fields/level_form.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/dialogs/export/export_dialog.h"
#include "widgets/dialogs/export/moment_form.h"
#include "widgets/dialogs/export/option_fields.h"
#include "widgets/dialogs/export/print_form.h"
#include "widgets/dialogs/picture_form.h"
#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QTabBar>
#include <algorithm>
#include <utility>

namespace ramure {

void ExportDialog::buildForm()
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(18, 18, 18, 14);
    layout->setSpacing(14);
    buildUses(layout);
    // No QFormLayout: its rows that are hidden take the height of others (Qt 6.4, where some wrap their
    // text).
    m_page = new QWidget(this);
    m_form = new QGridLayout(m_page);
    m_form->setContentsMargins(0, 0, 0, 0);
    m_form->setHorizontalSpacing(14);
    m_form->setVerticalSpacing(10);
    m_form->setColumnStretch(1, 1);
    m_format = new QComboBox(this);
    m_format->setObjectName(QStringLiteral("exportFormat"));
    fillFormats();
    addRows();
    ExportOptions kept;
    kept.space = m_preferences->exportSpace();
    m_fields->set(kept, ofImport);
    m_scroll = new QScrollArea(this);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setWidgetResizable(true);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setWidget(m_page);
    layout->addWidget(m_scroll, 1);
    buildFaults(layout);
    buildProgress(layout);
}

/// Returns a row whose first widget takes the spare room.
static QLayout* besides(int spacing, const QList<QWidget*>& widgets)
{
    auto* layout = new QHBoxLayout;
    layout->setSpacing(spacing);
    for (QWidget* widget : widgets)
        layout->addWidget(widget, widget == widgets.front() ? 1 : 0);
    return layout;
}

QLayout* ExportDialog::buildWind()
{
    auto* wind = static_cast<QComboBox*>(m_fields->make("wind", this));
    m_showWind = new QPushButton(this);
    m_showWind->setObjectName(QStringLiteral("exportShowWind"));
    m_showWind->setCheckable(true);
    m_showWind->setAutoDefault(false);
    m_showWind->setEnabled(false);
    m_showWind->hide();
    const auto show = [this, wind] {
        emit windShown(static_cast<WindProfile>(m_showWind->isChecked() ? wind->currentIndex() : 0));
    };
    connect(m_showWind, &QPushButton::toggled, this, show);
    connect(wind, &QComboBox::currentIndexChanged, this, [this, show](int row) {
        m_showWind->setEnabled(row > 0);
        if (row == 0)
            m_showWind->setChecked(false);
        else if (m_showWind->isChecked())
            show();
    });
    return besides(8, {wind, m_showWind});
}

void ExportDialog::addRow(const char* text, QWidget* field, std::function<bool(const ExportPage&)> isShown)
{
    const int row = static_cast<int>(m_rows.size());
    auto* label = new QLabel(this);                         // setTexts() fills it
    label->setMinimumHeight(m_format->sizeHint().height()); // beside the first line of its field
    m_form->addWidget(label, row, 0, Qt::AlignTop);
    m_form->addWidget(field, row, 1);
    m_rows.push_back({text, nullptr, label, field, std::move(isShown)});
}

void ExportDialog::addRow(const ExportOption& option, QWidget* field)
{
    addRow("", field, [&option](const ExportPage& page) { return isOffered(option, page); });
    m_rows.back().option = &option;
}

void ExportDialog::addRows()
{
    const auto held = [this](QLayout* layout) {
        auto* holder = new QWidget(this);
        layout->setContentsMargins(0, 0, 0, 0);
        holder->setLayout(layout);
        return holder;
    };
    const auto add = [this](const char* key) { addRow(optionOfKey(key), m_fields->make(key, this)); };
    const auto isMesh = [](const ExportPage& page) { return page.format && !page.isPrint; };
    addRow(QT_TR_NOOP("Settings"), held(buildKept()));
    addRow(QT_TR_NOOP("Format"), m_format);
    addRow(QT_TR_NOOP("For print"), m_printing = new PrintForm(m_fields, this),
           [](const ExportPage& page) { return page.use == ExportUse::Print; });
    add("model");
    addRow(QT_TR_NOOP("Parts"), held(buildParts()), isMesh);
    add("instances");
    addRow(QT_TR_NOOP("Levels"), m_levels = new LevelForm(this),
           [](const ExportPage& page) { return page.use == ExportUse::Game; });
    addRow(optionOfKey("wind"), held(buildWind()));
    addRow(optionOfKey("maps"),
           held(besides(16, {m_fields->make("maps", this), m_fields->make("compressed", this)})));
    addRow(QT_TR_NOOP("Axes and unit"), held(buildSpace()), [isMesh](const ExportPage& page) {
        return isMesh(page) && (page.format->holds & holdsSpace) != 0;
    });
    addRow(QT_TR_NOOP("Nodes"), held(buildScope()),
           [](const ExportPage& page) { return page.format != nullptr; });
    m_moments = new MomentForm(m_document->scene().timeline(), m_shownFrame, this);
    addRow(QT_TR_NOOP("Moment"), m_moments,
           [isMesh](const ExportPage& page) { return !page.format || isMesh(page); });
    add("joints");
    // A new option has no place of its own: it stands here.
    for (const ExportOption& option : exportOptions())
        if (*option.key != '\0' && !m_fields->has(option))
            add(option.key);
    addRow(QT_TR_NOOP("Picture"), m_pictures = new PictureForm(this),
           [](const ExportPage& page) { return !page.format; });
    addRow(QT_TR_NOOP("File"), held(buildTarget()));
    m_form->setRowStretch(static_cast<int>(m_rows.size()), 1); // what is left
    QWidget* before = m_uses;
    for (QWidget* next :
         {static_cast<QWidget*>(m_kept), static_cast<QWidget*>(m_keep), static_cast<QWidget*>(m_forget),
          static_cast<QWidget*>(m_format), static_cast<QWidget*>(m_printing)})
        setTabOrder(std::exchange(before, next), next);
}

/// A page for each use.
void ExportDialog::buildUses(QVBoxLayout* layout)
{
    m_uses = new QTabBar(this);
    m_uses->setObjectName(QStringLiteral("exportUses"));
    m_uses->setExpanding(false);
    m_uses->setUsesScrollButtons(true);
    for (std::size_t i = 0; i < exportUses.size(); ++i)
        m_uses->addTab(QString());
    layout->addWidget(m_uses);
}

/// Those of the page, the usual one first.
void ExportDialog::fillFormats()
{
    const QSignalBlocker quiet(m_format);
    m_format->clear();
    for (const QString& id : formatsOf(m_use))
        m_format->addItem(QString(), id);
    setFormatTexts();
}

void ExportDialog::setUse(ExportUse use)
{
    m_uses->setCurrentIndex(static_cast<int>(use));
}

void ExportDialog::setLevels(const LevelOptions& levels)
{
    setUse(ExportUse::Game);
    m_levels->setOptions(levels);
}

void ExportDialog::offerLevels(const LevelOptions& levels)
{
    m_offered = levels;
    if (m_use == ExportUse::Game)
        m_levels->setOptions(levels);
}

void ExportDialog::offerWind()
{
    m_showWind->show();
}

void ExportDialog::takeUse(int tab)
{
    m_showWind->setChecked(false);
    m_pages[m_use] = settings();
    m_use = exportUses[static_cast<std::size_t>(tab)];
    fillFormats();
    fillKept();
    setMessage({}, false);
    {
        const QSignalBlocker once(m_printing); // the page is laid out below
        m_printing->setWanted(m_use == ExportUse::Print);
    }
    forgetPrint();
    takeFormat();
    turnPage(m_use);
}

QLayout* ExportDialog::buildSpace()
{
    m_scaleLabel = new QLabel(this);
    auto* row = new QHBoxLayout;
    row->setSpacing(6);
    row->addWidget(m_fields->make("up", this));
    row->addWidget(m_fields->make("unit", this));
    row->addSpacing(8);
    row->addWidget(m_scaleLabel);
    row->addWidget(m_fields->make("scale", this));
    row->addStretch(1);
    m_scaleLabel->setBuddy(m_fields->of<QWidget>("scale"));
    return row;
}

QLayout* ExportDialog::buildScope()
{
    m_selection = new QCheckBox(this);
    m_selection->setEnabled(!m_document->selection().nodes.empty());
    m_hidden = new QCheckBox(this);
    auto* scope = new QVBoxLayout;
    scope->setSpacing(6);
    scope->addWidget(m_selection);
    scope->addWidget(m_hidden);
    return scope;
}

QLayout* ExportDialog::buildParts()
{
    m_branches = new QCheckBox(this);
    m_leaves = new QCheckBox(this);
    m_apples = new QCheckBox(this);
    auto* boxes = new QHBoxLayout;
    boxes->setSpacing(16);
    for (QCheckBox* box : {m_branches, m_leaves, m_apples}) {
        box->setChecked(true);
        boxes->addWidget(box);
    }
    boxes->addWidget(m_fields->make("texture", this));
    m_fields->of<QCheckBox>("texture")->setChecked(true);
    boxes->addStretch(1);
    m_partsNote = new QLabel(this);
    m_partsNote->setObjectName(QStringLiteral("partsNote"));
    m_partsNote->setTextFormat(Qt::PlainText);
    m_partsNote->setWordWrap(true);
    auto* parts = new QVBoxLayout;
    parts->setSpacing(6);
    parts->addLayout(boxes);
    parts->addWidget(m_partsNote);
    return parts;
}

/// The file, and below it what that will come to.
QLayout* ExportDialog::buildTarget()
{
    m_path = new QLineEdit(this);
    m_path->setMinimumWidth(320);
    m_browse = new QPushButton(this);
    m_summary = new QLabel(this);
    m_summary->setObjectName(QStringLiteral("dim"));
    m_summary->setTextFormat(Qt::PlainText);
    m_summary->setWordWrap(true);
    m_summary->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_summary->setMinimumHeight(2 * m_summary->fontMetrics().lineSpacing()); // long names take two lines
    auto* file = new QHBoxLayout;
    file->setSpacing(8);
    file->addWidget(m_path, 1);
    file->addWidget(m_browse);
    auto* target = new QVBoxLayout;
    target->setSpacing(6);
    target->addLayout(file);
    target->addWidget(m_summary);
    return target;
}

/// What is below the form: the message, the bar, the buttons.
void ExportDialog::buildProgress(QVBoxLayout* layout)
{
    m_message = new QLabel(this);
    m_message->setWordWrap(true);
    m_message->hide();
    layout->addWidget(m_message);
    m_progress = new QProgressBar(this);
    m_progress->setRange(0, 1000);
    m_progress->setTextVisible(false);
    QSizePolicy policy = m_progress->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    m_progress->setSizePolicy(policy);
    m_progress->hide();
    layout->addWidget(m_progress);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    m_export = new QPushButton(this);
    m_export->setDefault(true);
    m_cancel = new QPushButton(this);
    m_cancel->setAutoDefault(false);
    m_browse->setAutoDefault(false);
    buttons->addStretch(1);
    buttons->addWidget(m_cancel);
    buttons->addWidget(m_export);
    layout->addLayout(buttons);
}

void ExportDialog::setFormatTexts()
{
    for (const FileFormat* format : fileFormats())
        if (const int row = m_format->findData(QString::fromLatin1(format->id)); row >= 0)
            m_format->setItemText(row, coreText(format->choice));
    if (const int row = m_format->findData(pictureFormat); row >= 0)
        m_format->setItemText(row, tr("PNG pictures of the view"));
}

void ExportDialog::setTexts()
{
    setWindowTitle(tr("Export"));
    setFormatTexts();
    for (std::size_t i = 0; i < exportUses.size(); ++i) {
        const int tab = static_cast<int>(i);
        m_uses->setTabText(tab, titleOf(exportUses[i]));
        m_uses->setTabToolTip(tab, m_uses->isTabEnabled(tab)
                                       ? tipOf(exportUses[i])
                                       : tr("Pictures need a view, which this machine cannot draw"));
    }
    m_uses->setAccessibleName(tr("What the export is for"));
    m_keep->setText(tr("Keep"));
    m_forget->setText(tr("Forget"));
    m_kept->lineEdit()->setPlaceholderText(tr("kept settings, or a name for these"));
    m_kept->setToolTip(
        tr("Settings of this page that were kept under a name, or those of its last export. Where files go "
           "is not part of them."));
    m_branches->setText(tr("Branches"));
    m_leaves->setText(tr("Leaves"));
    m_apples->setText(tr("Fruit"));
    m_selection->setText(tr("Only what is selected"));
    const QString whole =
        tr("Trees, arms as they are at the moment, terrains, primitives and imported meshes "
           "are written where they stand in the world, each under a name of its own.");
    m_selection->setToolTip(whole);
    m_hidden->setToolTip(whole);
    m_hidden->setText(tr("Hidden nodes too"));
    m_browse->setText(tr("Browse…"));
    m_show->setText(tr("Show"));
    m_showWind->setText(tr("Show"));
    m_showWind->setToolTip(tr("In the view behind this dialog, trees move as they will in that engine"));
    m_cancel->setText(tr("Cancel"));
    m_fields->setTexts();
    m_scaleLabel->setText(coreText(optionOfKey("scale").label));
    int widest = 0; // also of the labels that a page hides: fields stay in their column from page to page
    for (const FormRow& row : m_rows) {
        if (!qobject_cast<QCheckBox*>(row.field))
            row.label->setText(row.option ? coreText(row.option->label) : tr(row.text));
        widest = std::max(widest, row.label->sizeHint().width());
    }
    m_form->setColumnMinimumWidth(0, widest);
    m_kept->setAccessibleName(tr("Settings"));
    m_format->setAccessibleName(tr("Format"));
    m_path->setAccessibleName(tr("File"));
    m_progress->setAccessibleName(tr("Progress of the export"));
    fillKept();
    updateWidgets();
}

} // namespace ramure
