#include "widgets/dialogs/variations/variations_dialog.h"

#include "core/generators/variety.h"
#include "core/qt/document/commands.h"
#include "core/qt/document/project/own_presets.h"
#include "widgets/base/chooser.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/texts/preset_title.h"
#include "widgets/base/theme/icons.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/dialogs/variations/variation_delegate.h"
#include "widgets/dialogs/variations/varied_params_form.h"
#include <QAction>
#include <QDir>
#include <QGridLayout>
#include <QLabel>
#include <QListView>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <algorithm>

namespace ramure {
namespace {

constexpr int formWidth = 260, soonMs = 250;
constexpr QSize usualSize{1096, 640}, leastSize{700, 420};

} // namespace

VariationsDialog::VariationsDialog(Document* document, Preferences* preferences, Chooser* chooser,
                                   QWidget* parent)
    : QDialog(parent)
    , m_document(document)
    , m_preferences(preferences)
    , m_chooser(chooser)
    , m_model(new VariationsModel(this))
    , m_view(new QListView(this))
    , m_form(new VariedParamsForm(this))
    , m_countLabel(new QLabel(tr("T&rees:"), this))
    , m_count(new QSpinBox(this))
    , m_hint(new QLabel(this))
    , m_progress(new QProgressBar(this))
    , m_other(new QPushButton(tr("Other &seeds"), this))
    , m_stop(new QPushButton(this))
    , m_close(new QPushButton(tr("&Close"), this))
    , m_openButton(new QPushButton(tr("&Open in place"), this))
    , m_table(new QPushButton(tr("Save as ta&ble"), this))
    , m_tableMenu(new QMenu(this))
{
    setObjectName(QStringLiteral("variations"));
    m_count->setRange(1, mostCount);
    m_count->setValue(usualCount);
    m_count->setKeyboardTracking(false);
    m_countLabel->setBuddy(m_count);
    m_soon.setSingleShot(true);
    m_soon.setInterval(soonMs);
    buildActions();
    buildLayout();
    connect(&m_soon, &QTimer::timeout, this, [this] { begin(m_first); });
    connect(m_form, &VariedParamsForm::changed, this, [this] {
        m_scale.reset();
        m_soon.start();
    });
    connect(m_count, &QSpinBox::valueChanged, &m_soon, qOverload<>(&QTimer::start));
    connect(m_other, &QPushButton::clicked, this, [this] { begin(m_first + m_count->value()); });
    connect(m_stop, &QPushButton::clicked, this, &VariationsDialog::stopOrGoOn);
    connect(m_close, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_openButton, &QPushButton::clicked, m_open, &QAction::trigger);
    connect(m_view->selectionModel(), &QItemSelectionModel::currentChanged, this, &VariationsDialog::follow);
    connect(m_view, &QListView::activated, m_open, &QAction::trigger);
    connect(m_model, &QAbstractItemModel::dataChanged, this, &VariationsDialog::follow);
    resize(usualSize);
    setMinimumSize(leastSize);
    m_count->setToolTip(tr("How many, each with another seed; those with a star stay besides"));
    m_other->setToolTip(tr("The seeds that follow; those with a star stay"));
    m_open->setToolTip(tr("The tree in the scene becomes this one (Return)"));
    m_openButton->setToolTip(m_open->toolTip());
    m_keep->setToolTip(tr("Put it into the gallery"));
    m_table->setToolTip(tr("Write a table, from which ramure-cli batch grows a file for each tree"));
    m_view->setAccessibleName(tr("Variations"));
    follow();
}

void VariationsDialog::buildActions()
{
    m_open = new QAction(icon("tree"), tr("&Open in place"), this);
    m_star = new QAction(this);
    m_star->setShortcut(Qt::Key_S);
    m_star->setShortcutContext(Qt::WidgetShortcut); // elsewhere it is a letter
    m_keep = new QAction(icon("save"), tr("&Keep as preset"), this);
    connect(m_open, &QAction::triggered, this, &VariationsDialog::openCurrent);
    connect(m_star, &QAction::triggered, this, &VariationsDialog::starCurrent);
    connect(m_keep, &QAction::triggered, this, &VariationsDialog::keepCurrent);
    using Choice = VariationsModel::Choice;
    for (const auto& [choice, text] : {std::pair(Choice::All, tr("Save &all as a table…")),
                                       {Choice::Starred, tr("Save those &with a star as a table…")},
                                       {Choice::Rest, tr("Save those with&out a star as a table…")}}) {
        QAction*& action = m_save[std::size_t(choice)];
        action = m_tableMenu->addAction(text);
        connect(action, &QAction::triggered, this, [this, choice = choice] { save(choice); });
    }
    auto* line = new QAction(this);
    line->setSeparator(true);
    m_view->addActions({m_open, m_star, m_keep, line});
    m_view->addActions({m_save.begin(), m_save.end()});
}

void VariationsDialog::buildLayout()
{
    auto* delegate = new VariationDelegate(m_view);
    connect(delegate, &VariationDelegate::starClicked, this, [this](const QModelIndex& index) {
        m_view->setCurrentIndex(index);
        starCurrent();
    });
    m_view->setModel(m_model);
    m_view->setItemDelegate(delegate);
    m_view->setViewMode(QListView::IconMode);
    m_view->setResizeMode(QListView::Adjust);
    m_view->setMovement(QListView::Static);
    m_view->setUniformItemSizes(true);
    m_view->setMouseTracking(true);
    m_view->setContextMenuPolicy(Qt::ActionsContextMenu);
    m_view->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_table->setMenu(m_tableMenu);
    m_hint->setWordWrap(true);
    m_hint->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_progress->setTextVisible(false);
    m_progress->setFixedWidth(120);
    for (QPushButton* button : {m_other, m_stop, m_close, m_openButton, m_table})
        button->setAutoDefault(false);
    auto* count = new QHBoxLayout;
    count->addWidget(m_countLabel);
    count->addWidget(m_count);
    count->addStretch(1);
    count->addWidget(m_other);
    auto* left = new QVBoxLayout;
    left->addLayout(count);
    left->addWidget(m_form, 1);
    auto* side = new QWidget(this);
    side->setFixedWidth(formWidth);
    left->setContentsMargins(0, 0, 0, 0);
    side->setLayout(left);
    auto* status = new QHBoxLayout;
    status->setSpacing(10);
    status->addWidget(m_hint, 1);
    status->addWidget(m_progress);
    status->addWidget(m_stop);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_table);
    buttons->addStretch(1);
    buttons->addWidget(m_openButton);
    buttons->addWidget(m_close);
    auto* layout = new QGridLayout(this);
    layout->setHorizontalSpacing(12);
    layout->addWidget(side, 0, 0, 2, 1);
    layout->addWidget(m_view, 0, 1);
    layout->addLayout(status, 1, 1);
    layout->addLayout(buttons, 2, 0, 1, 2);
    layout->setColumnStretch(1, 1);
    layout->setRowStretch(0, 1);
}

void VariationsDialog::offerFor(NodeId tree)
{
    const Node* like = m_document->scene().find(tree);
    if (!like || like->kind != NodeKind::Tree)
        return;
    const AngleUnit unit = m_preferences->angleUnit();
    m_model->setAngleUnit(unit == AngleUnit::Degrees);
    const bool goesOn = tree == m_tree && (like->params == m_like.params || like->params == m_opened);
    if (!goesOn) {
        m_tree = tree;
        m_like = *like;
        m_opened = like->params;
        m_touched.clear();
        m_scale.reset();
        m_model->clear();
        m_form->setTree(like->params);
    }
    m_form->setAngleUnit(unit);
    show();
    raise();
    activateWindow();
    m_view->setFocus();
    if (!goesOn)
        begin(like->params.grammar.seed + 1);
    setWindowTitle(tr("Variations of %1").arg(presetTitle(QString::fromStdString(m_like.name))));
    follow();
}

void VariationsDialog::begin(std::int64_t firstSeed)
{
    m_soon.stop();
    m_said.clear();
    m_isStopped = false;
    // Beyond the last seed there is none.
    const auto most = std::int64_t(findParam("grammar.seed")->hardMax) - m_count->value();
    m_first = std::min(firstSeed, most);
    m_model->offer(spreadVariations(m_form->params(), m_first, m_count->value()));
    for (const ParamDef* def : paramsOf(m_model->chosen(VariationsModel::Choice::All)))
        if (std::ranges::find(m_touched, def) == m_touched.end())
            m_touched.push_back(def);
    m_view->setCurrentIndex(m_model->index(0));
    drawNext();
}

void VariationsDialog::drawNext()
{
    const auto varied = m_form->params();
    const bool agesVary = std::ranges::count(varied, findParam("growth.age"), &VariedParam::def) > 0;
    const int row = m_isStopped ? -1 : m_model->nextUndrawn(agesVary && !m_scale);
    if (row < 0) {
        m_pictures.stop();
        return follow();
    }
    const auto params = variedParams(m_like.params, m_model->at(row));
    if (!params) {
        m_model->setProblem(row, errorText(params.error()));
        return drawNext();
    }
    m_pictures.draw(
        *params, VariationDelegate::pictureSize * devicePixelRatioF(),
        [this, row, agesVary](Expected<TreePicture>&& made) {
            if (made && agesVary)
                m_scale = made->camera;
            if (made)
                m_model->setPicture(row, QPixmap::fromImage(std::move(made->image)));
            else
                m_model->setProblem(row, errorText(made.error()));
            drawNext();
        },
        m_scale);
    follow();
}

void VariationsDialog::stopOrGoOn()
{
    m_isStopped = !m_isStopped;
    drawNext();
}

int VariationsDialog::current() const
{
    return m_view->currentIndex().row();
}

void VariationsDialog::openCurrent()
{
    if (current() < 0)
        return;
    const Variation& variation = m_model->at(current());
    const auto values = valuesOf(m_like.params, variation, m_touched);
    if (const auto done =
            edit::setParams(*m_document, {m_tree}, values, tr("Variation with seed %1").arg(variation.seed));
        !done)
        return say(errorText(done.error()));
    m_opened = m_document->scene().find(m_tree)->params;
    say(tr("The tree in the scene grows like it. Undo brings the one before back."));
}

void VariationsDialog::starCurrent()
{
    if (current() >= 0)
        m_model->setStarred(current(), !m_model->isStarred(current()));
}

void VariationsDialog::keepCurrent()
{
    if (current() < 0)
        return;
    const Variation& variation = m_model->at(current());
    Node tree = m_like;
    auto params = variedParams(m_like.params, variation);
    if (!params)
        return say(errorText(params.error()));
    tree.params = std::move(*params);
    const OwnPresets own;
    const QString name = own.freeName(
        tr("%1, seed %2").arg(presetTitle(QString::fromStdString(m_like.name))).arg(variation.seed));
    if (const auto saved = own.save(name, tree); !saved)
        return say(errorText(saved.error()));
    emit presetKept();
    say(tr("Kept in the gallery as \"%1\".").arg(name));
}

void VariationsDialog::save(VariationsModel::Choice choice)
{
    const std::vector<Variation> rows = m_model->chosen(choice);
    if (rows.empty())
        return;
    const QString path =
        m_chooser->saveFile(tr("Save the variations as a table"), QStringLiteral("variations.csv"),
                            tr("Tables for ramure-cli batch (*.csv)"), QStringLiteral("csv"));
    if (path.isEmpty())
        return;
    if (const auto saved = saveVariations(m_like, rows, path); !saved)
        return say(errorTextWithPlace(saved.error()));
    say(tr("%Ln tree(s) written: ramure-cli batch \"%1\" -o FOLDER grows them.", nullptr, int(rows.size()))
            .arg(QDir::toNativeSeparators(path)));
}

void VariationsDialog::say(const QString& text)
{
    m_said = text;
    follow();
}

/// What can be done now, and how far the pictures are.
void VariationsDialog::follow()
{
    const bool any = current() >= 0;
    for (QAction* action : {m_open, m_star, m_keep})
        action->setEnabled(any);
    m_openButton->setEnabled(any);
    m_star->setText(any && m_model->isStarred(current()) ? tr("Take the &star away") : tr("Set a &star"));
    const int count = m_model->rowCount(), drawn = m_model->drawn();
    const int starred = int(m_model->chosen(VariationsModel::Choice::Starred).size());
    using Choice = VariationsModel::Choice;
    m_save[std::size_t(Choice::All)]->setEnabled(count > 0);
    m_save[std::size_t(Choice::Starred)]->setEnabled(starred > 0);
    m_save[std::size_t(Choice::Rest)]->setEnabled(starred < count);
    const bool goesOn = drawn < count;
    m_progress->setVisible(goesOn);
    m_progress->setMaximum(std::max(count, 1));
    m_progress->setValue(drawn);
    m_stop->setVisible(goesOn);
    m_stop->setText(m_isStopped ? tr("&Go on") : tr("S&top"));
    if (!m_said.isEmpty())
        return m_hint->setText(m_said);
    const QString chance = variesByChance(m_like.params) || !m_form->params().empty()
                               ? QString()
                               : tr("Nothing but the places of its leaves varies by chance.") + u' ';
    m_hint->setText(chance +
                    (goesOn ? tr("Growing %1 of %2 …").arg(drawn + 1).arg(count)
                            : tr("%Ln tree(s), ", nullptr, count) + tr("%Ln with a star", nullptr, starred)));
}

void VariationsDialog::showEvent(QShowEvent* event)
{
    QDialog::showEvent(event);
    drawNext();
}

/// Nobody sees what is not drawn yet.
void VariationsDialog::hideEvent(QHideEvent* event)
{
    m_pictures.stop();
    QDialog::hideEvent(event);
}

} // namespace ramure
