// The widgets of the export dialog, and what they say.
#include "core/io/formats/file_format.h"
#include "core/qt/document/document.h"
#include "widgets/base/fields/level_form.h"
#include "widgets/base/named.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/dialogs/export/export_dialog.h"
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
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QTabBar>
#include <algorithm>

namespace ramure {

void ExportDialog::buildForm()
{
    auto* layout = layoutOf<QVBoxLayout>(this, 14, {18, 18, 18, 14});
    buildUses(layout);
    // No QFormLayout: its rows that are hidden take the height of others (Qt 6.4, where some wrap their
    // text).
    m_page = new QWidget(this);
    m_form = layoutOf<QGridLayout>(m_page);
    m_form->setHorizontalSpacing(14);
    m_form->setVerticalSpacing(10);
    m_form->setColumnStretch(1, 1);
    m_format = named(new QComboBox(this), "exportFormat");
    m_format->setAccessibleName(tr("Format"));
    fillFormats();
    addRows();
    m_fields->setTexts();
    int widest = 0; // also of the labels that a page hides: fields stay in their column from page to page
    for (const FormRow& row : m_rows)
        widest = std::max(widest, row.label->sizeHint().width());
    m_form->setColumnMinimumWidth(0, widest);
    ExportOptions kept;
    kept.space = m_preferences->exportSpace();
    m_fields->set(kept, ofImport);
    m_scroll = new QScrollArea(this);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setWidgetResizable(true);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setWidget(m_page);
    layout->addWidget(m_scroll, 1);
    layout->addWidget(m_faults = new FaultsLine(m_document, this));
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
    m_showWind = named(new QPushButton(tr("Show"), this), "exportShowWind");
    m_showWind->setToolTip(tr("In the view behind this dialog, trees move as they will in that engine"));
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

void ExportDialog::addRow(const QString& text, QWidget* field, std::function<bool(const ExportPage&)> isShown)
{
    const int row = static_cast<int>(m_rows.size());
    auto* label = new QLabel(qobject_cast<QCheckBox*>(field) ? QString() : text, this);
    label->setMinimumHeight(m_format->sizeHint().height()); // beside the first line of its field
    m_form->addWidget(label, row, 0, Qt::AlignTop);
    m_form->addWidget(field, row, 1);
    m_rows.push_back({label, field, std::move(isShown)});
}

void ExportDialog::addRow(const ExportOption& option, QWidget* field)
{
    addRow(coreText(option.label), field,
           [&option](const ExportPage& page) { return isOffered(option, page); });
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
    addRow(tr("Settings"), m_kept = new KeptForm(
                               m_preferences, [this] { return settings(); }, this));
    addRow(tr("Format"), m_format);
    addRow(tr("For print"), m_print.form = new PrintForm(m_fields, this),
           [](const ExportPage& page) { return page.use == ExportUse::Print; });
    add("model");
    addRow(tr("Parts"), m_parts = new PartsForm(m_fields, this), isMesh);
    add("instances");
    addRow(tr("Levels"), m_levels = new LevelForm(this),
           [](const ExportPage& page) { return page.use == ExportUse::Game; });
    addRow(optionOfKey("wind"), held(buildWind()));
    addRow(optionOfKey("maps"),
           held(besides(16, {m_fields->make("maps", this), m_fields->make("compressed", this)})));
    addRow(tr("Axes and unit"), held(buildSpace()), [isMesh](const ExportPage& page) {
        return isMesh(page) && (page.format->holds & holdsSpace) != 0;
    });
    addRow(tr("Nodes"), held(buildScope()), [](const ExportPage& page) { return page.format != nullptr; });
    m_moments = new MomentForm(m_document->scene().timeline(), m_shownFrame, this);
    addRow(tr("Moment"), m_moments,
           [isMesh](const ExportPage& page) { return !page.format || isMesh(page); });
    add("joints");
    // A new option has no place of its own: it stands here.
    for (const ExportOption& option : exportOptions())
        if (*option.key != '\0' && !m_fields->has(option))
            add(option.key);
    addRow(tr("Picture"), m_pictures = new PictureForm(this),
           [](const ExportPage& page) { return !page.format; });
    addRow(tr("File"), held(buildTarget()));
    m_form->setRowStretch(static_cast<int>(m_rows.size()), 1); // what is left
}

/// A page for each use.
void ExportDialog::buildUses(QVBoxLayout* layout)
{
    m_uses = named(new QTabBar(this), "exportUses");
    m_uses->setExpanding(false);
    m_uses->setUsesScrollButtons(false); // on a small screen, too, all of them are seen
    m_uses->setAccessibleName(tr("Purpose of the export"));
    for (const ExportUse use : exportUses)
        m_uses->setTabToolTip(m_uses->addTab(titleOf(use)), tipOf(use));
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
    m_kept->setUse(m_use);
    setMessage({}, false);
    {
        const QSignalBlocker once(m_print.form); // the page is laid out below
        m_print.form->setWanted(m_use == ExportUse::Print);
    }
    m_print.preparer->forget();
    takeFormat();
    turnPage(m_use);
}

QLayout* ExportDialog::buildSpace()
{
    auto* label = new QLabel(coreText(optionOfKey("scale").label), this);
    auto* row = new QHBoxLayout;
    row->setSpacing(6);
    row->addWidget(m_fields->make("up", this));
    row->addWidget(m_fields->make("unit", this));
    row->addSpacing(8);
    row->addWidget(label);
    row->addWidget(m_fields->make("scale", this));
    row->addStretch(1);
    label->setBuddy(m_fields->of<QWidget>("scale"));
    return row;
}

QLayout* ExportDialog::buildScope()
{
    m_selection = new QCheckBox(tr("Selection only"), this);
    m_selection->setEnabled(!m_document->selection().nodes.empty());
    m_hidden = new QCheckBox(tr("Hidden nodes too"), this);
    for (QCheckBox* box : {m_selection, m_hidden})
        box->setToolTip(tr("Trees, arms as they are at the moment, terrains, primitives and imported meshes "
                           "are written where they stand in the world, each under a name of its own."));
    auto* scope = new QVBoxLayout;
    scope->setSpacing(6);
    scope->addWidget(m_selection);
    scope->addWidget(m_hidden);
    return scope;
}

/// The file, and below it what that will come to.
QLayout* ExportDialog::buildTarget()
{
    m_path = new QLineEdit(this);
    m_path->setMinimumWidth(320);
    m_path->setAccessibleName(tr("File"));
    m_browse = new QPushButton(tr("Browse…"), this);
    m_browse->setAutoDefault(false);
    m_summary = named(new QLabel(this), "dim");
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
    m_progress->setAccessibleName(tr("Progress of the export"));
    QSizePolicy policy = m_progress->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    m_progress->setSizePolicy(policy);
    m_progress->hide();
    layout->addWidget(m_progress);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    m_export = new QPushButton(this);
    m_export->setDefault(true);
    auto* cancel = new QPushButton(tr("Cancel"), this);
    cancel->setAutoDefault(false);
    connect(cancel, &QPushButton::clicked, this, &ExportDialog::reject);
    buttons->addStretch(1);
    buttons->addWidget(cancel);
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
    if (const int row = m_format->findData(QStringLiteral("mp4")); row >= 0)
        m_format->setItemText(row, tr("MP4 film of the view (H.264)"));
    if (const int row = m_format->findData(QStringLiteral("webm")); row >= 0)
        m_format->setItemText(row, tr("WebM film of the view (VP9)"));
}

} // namespace ramure
