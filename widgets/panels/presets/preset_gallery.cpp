#include "widgets/panels/presets/preset_gallery.h"

#include "core/params/presets.h"
#include "widgets/base/core_text.h"
#include "widgets/panels/presets/picture_button.h"
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QRegularExpression>
#include <QResizeEvent>
#include <QVBoxLayout>
#include <algorithm>

namespace ramure {
namespace {

constexpr int gap = 12;
constexpr int usualColumns = 2;

/// All names that it has and what it is like, to search in.
QString searchedText(const Preset& preset)
{
    return (QString::fromLatin1(preset.name) + u' ' + spacedName(QString::fromLatin1(preset.name)) + u' ' +
            QString::fromUtf8(preset.latin) + u' ' + coreText(preset.description) + u' ' +
            coreText(preset.group))
        .toLower();
}

} // namespace

QString spacedName(const QString& preset)
{
    static const QRegularExpression word(QStringLiteral("(?<=[a-z])(?=[A-Z][a-z])"));
    return QString(preset).replace(word, QStringLiteral(" "));
}

PresetGallery::PresetGallery(int pictureWidth, QWidget* parent)
    : QWidget(parent)
    , m_pictureWidth(pictureWidth)
    , m_search(new QLineEdit(this))
    , m_none(new QLabel(this))
{
    m_search->setObjectName(QStringLiteral("presetSearch"));
    m_search->setClearButtonEnabled(true);
    m_none->setObjectName(QStringLiteral("dim"));
    m_none->setWordWrap(true);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    layout->addWidget(m_search);
    layout->addWidget(m_none);
    for (std::size_t i = 0; i < presets().size(); ++i)
        addPicture(i);
    layout->addStretch(1);
    connect(m_search, &QLineEdit::textChanged, this, &PresetGallery::filter);
    retranslate();
    filter();
}

void PresetGallery::addPicture(std::size_t preset)
{
    const Preset& own = presets()[preset];
    if (m_groups.empty() || m_groups.back().name != std::string_view(own.group)) {
        auto* heading = new QLabel(this);
        heading->setObjectName(QStringLiteral("galleryGroup"));
        auto* grid = new QGridLayout;
        grid->setSpacing(gap);
        auto* all = static_cast<QVBoxLayout*>(layout());
        all->addWidget(heading);
        all->addLayout(grid);
        m_groups.push_back({own.group, heading, grid, {}});
    }
    const QString name = QString::fromLatin1(own.name);
    auto* picture = new PictureButton(name, m_pictureWidth, this);
    picture->setText(spacedName(name));
    picture->setObjectName(QStringLiteral("preset.") + name);
    picture->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(picture, &QAbstractButton::clicked, this, [this, name] { emit chosen(name); });
    connect(picture, &QWidget::customContextMenuRequested, this,
            [this, picture](const QPoint& at) { openMenu(picture, at); });
    m_groups.back().pictures.push_back(picture);
}

QWidget* PresetGallery::first() const
{
    for (const Group& group : m_groups)
        for (PictureButton* picture : group.pictures)
            if (!picture->isHidden())
                return picture;
    return nullptr;
}

void PresetGallery::addChoice(QAction* action)
{
    m_choices += action;
}

void PresetGallery::openMenu(PictureButton* picture, const QPoint& at)
{
    if (m_choices.isEmpty())
        return;
    m_menuPreset = picture->preset();
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addActions(m_choices);
    menu->popup(picture->mapToGlobal(at));
}

void PresetGallery::filter()
{
    const QStringList words = m_search->text().toLower().split(u' ', Qt::SkipEmptyParts);
    std::size_t at = 0;
    bool any = false;
    for (const Group& group : m_groups) {
        bool some = false;
        for (PictureButton* picture : group.pictures) {
            const QString text = searchedText(presets()[at++]);
            const bool hit =
                std::ranges::all_of(words, [&text](const QString& word) { return text.contains(word); });
            picture->setVisible(hit);
            some = some || hit;
        }
        group.heading->setVisible(some);
        any = any || some;
    }
    m_none->setVisible(!any);
    m_none->setText(
        tr("No tree is called “%1”. Search for a name, a Latin name or a word of its description.")
            .arg(m_search->text().trimmed()));
    m_columns = 0;
    arrange();
}

/// What is shown, without gaps, in as many columns as there is room for.
void PresetGallery::arrange()
{
    const int columns = std::max(1, (width() + gap) / columnWidth());
    if (columns == m_columns)
        return;
    m_columns = columns;
    for (const Group& group : m_groups) {
        int at = 0;
        for (PictureButton* picture : group.pictures) {
            group.grid->removeWidget(picture);
            if (picture->isHidden())
                continue;
            group.grid->addWidget(picture, at / columns, at % columns, Qt::AlignLeft | Qt::AlignTop);
            ++at;
        }
        for (int column = 0; column < group.grid->columnCount(); ++column)
            group.grid->setColumnStretch(column, column == columns ? 1 : 0);
        group.grid->setColumnStretch(columns, 1);
    }
}

/// With the gap beside it.
int PresetGallery::columnWidth() const
{
    return m_groups.front().pictures.front()->sizeHint().width() + gap;
}

QSize PresetGallery::sizeHint() const
{
    return {usualColumns * columnWidth() - gap, QWidget::sizeHint().height()};
}

QSize PresetGallery::minimumSizeHint() const
{
    return {columnWidth() - gap, QWidget::minimumSizeHint().height()};
}

void PresetGallery::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    arrange();
}

void PresetGallery::retranslate()
{
    m_search->setPlaceholderText(tr("Search trees"));
    m_search->setAccessibleName(m_search->placeholderText());
    std::size_t at = 0;
    for (const Group& group : m_groups) {
        group.heading->setText(coreText(group.name));
        for (PictureButton* picture : group.pictures) {
            const Preset& preset = presets()[at++];
            const QString about = coreText(preset.description), latin = QString::fromUtf8(preset.latin);
            picture->setToolTip(latin.isEmpty() ? about
                                                : tr("%1: %2", "Latin name: habit").arg(latin, about));
            picture->setAccessibleDescription(about);
        }
    }
}

void PresetGallery::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
        filter();
    }
    QWidget::changeEvent(event);
}

} // namespace ramure
