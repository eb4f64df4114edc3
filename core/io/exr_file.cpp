#include "core/io/exr_file.h"

#include "core/base/file_writer.h"
#include "core/io/grey_picture.h"
#include "core/io/light_picture.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfRgbaFile.h>
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

/// The library writes its table of rows last, in the middle: FileWriter cannot go back.
class ExrBytes : public Imf::OStream
{
public:
    ExrBytes()
        : Imf::OStream("")
    {
    }
    void write(const char* bytes, int count) override
    {
        const auto size = static_cast<std::size_t>(count);
        m_bytes.resize(std::max(m_bytes.size(), m_at + size));
        m_bytes.replace(m_at, size, bytes, size);
        m_at += size;
    }
    std::uint64_t tellp() override { return m_at; }
    void seekp(std::uint64_t at) override { m_at = at; }
    [[nodiscard]] const std::string& bytes() const { return m_bytes; }

private:
    std::string m_bytes;
    std::size_t m_at = 0;
};

/// Null: the file has no channels.
const char* greyChannel(const Imf::ChannelList& channels)
{
    for (const char* name : {"R", "Y"})
        if (channels.findChannel(name))
            return name;
    return channels.begin() == channels.end() ? nullptr : channels.begin().name();
}

} // namespace

Expected<GreyPicture> readExrNumbers(const std::string& path)
{
    constexpr int ownThreadAlone = 0;
    GreyPicture out;
    out.kind = GreyPicture::Kind::Numbers;
    try {
        Imf::InputFile file(path.c_str(), ownThreadAlone);
        const auto window = file.header().dataWindow();
        out.width = window.max.x - window.min.x + 1;
        out.height = window.max.y - window.min.y + 1;
        RAMURE_TRY(checkGreySize(out.width, out.height));
        const char* channel = greyChannel(file.header().channels());
        if (!channel)
            return fail(ErrorCode::Invalid, RAMURE_NOOP("the picture has no channels"));
        const auto width = static_cast<std::size_t>(out.width);
        out.values.resize(width * static_cast<std::size_t>(out.height));
        // The library takes the place of the pixel (0, 0), which may lie outside.
        const std::ptrdiff_t first = std::ptrdiff_t(window.min.y) * out.width + window.min.x;
        Imf::FrameBuffer buffer;
        buffer.insert(channel, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(out.values.data() - first),
                                          sizeof(float), sizeof(float) * width));
        file.setFrameBuffer(buffer);
        file.readPixels(window.min.y, window.max.y);
    } catch (const std::exception& error) { // of the library
        return fail(ErrorCode::Syntax, RAMURE_NOOP("the picture is damaged: %1"), {error.what()});
    }
    const auto bad = std::ranges::find_if(out.values, [](float value) { return !std::isfinite(value); });
    if (bad != out.values.end())
        return fail(ErrorCode::Invalid, RAMURE_NOOP("row %1 has a pixel that is no finite number"),
                    {std::to_string((bad - out.values.begin()) / out.width + 1)});
    return out;
}

Expected<void> writeExr(const std::string& path, int width, int height, std::span<const glm::vec4> pixels)
{
    ExrBytes out;
    try {
        Imf::Header header(width, height);
        header.compression() = Imf::ZIP_COMPRESSION;
        Imf::FrameBuffer buffer;
        constexpr const char* names[] = {"R", "G", "B", "A"};
        for (int channel = 0; channel < 4; ++channel) {
            header.channels().insert(names[channel], Imf::Channel(Imf::FLOAT));
            // The library only reads through the pointer.
            char* first = reinterpret_cast<char*>(const_cast<float*>(&pixels[0][channel]));
            buffer.insert(names[channel], Imf::Slice(Imf::FLOAT, first, sizeof(glm::vec4),
                                                     sizeof(glm::vec4) * static_cast<std::size_t>(width)));
        }
        constexpr int ownThreadAlone = 0;
        Imf::OutputFile file(out, header, ownThreadAlone);
        file.setFrameBuffer(buffer);
        file.writePixels(height);
    } catch (const std::exception& error) { // of the library
        auto failed = fail(ErrorCode::Io, RAMURE_NOOP("the texture cannot be written: %1"), {error.what()});
        failed.value().file = path;
        return failed;
    }
    return writeFile(path, out.bytes());
}

Expected<void> readExrRows(const std::string& path, const LightRows& rows)
{
    constexpr int largestSide = 65536, ownThreadAlone = 0;
    try {
        Imf::Header::setMaxImageSize(largestSide, largestSide);
        Imf::RgbaInputFile file(path.c_str(), ownThreadAlone);
        const auto window = file.dataWindow();
        const int width = window.max.x - window.min.x + 1, height = window.max.y - window.min.y + 1;
        RAMURE_TRY(rows.begin(width, height));
        std::vector<Imf::Rgba> row(static_cast<std::size_t>(width));
        std::vector<glm::vec3> light(row.size());
        for (int y = 0; y < height; ++y) {
            // The library takes the place of the window's first pixel.
            file.setFrameBuffer(row.data() - window.min.x, 1, 0);
            file.readPixels(window.min.y + y);
            for (std::size_t x = 0; x < row.size(); ++x)
                light[x] = {row[x].r, row[x].g, row[x].b};
            RAMURE_TRY(rows.add(y, light));
        }
    } catch (const std::exception& error) { // of the library
        return fail(ErrorCode::Syntax, RAMURE_NOOP("the picture is damaged: %1"), {error.what()});
    }
    return {};
}

} // namespace ramure
