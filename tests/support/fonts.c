#include "support/fonts.h"

#include "geometry/layers.h"
#include "support/check.h"

#include <stdlib.h>
#include <unistd.h>

mt_font *mt_test_font(const char *path) {
    if (access(path, R_OK) != 0) {
        if (getenv("MORPHOTYPE_FONTS_REQUIRED")) fail_msg("%s is not installed", path);
        print_message("%s is not installed\n", path);
        skip();
    }
    mt_font *font = NULL;
    mt_assert_ok(mt_font_open(path, &font));
    return font;
}

const uint32_t mt_test_latin[] =
    U"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789.,:;!?&@%#$()[]{}*+-=/<>\"'"
    U"ÄÅÆÇÉÑÖØÞßäåæçéñöøþĐŁŒ§©®±µ¶½€ΑΒΓΔΘΛΞΠΣΦΨΩαβγδεζηθλμξπρσφψωБГДЖЗИЛФЦЧШЩЪЮЯбджзфю";
const int mt_test_latin_count = sizeof mt_test_latin / sizeof *mt_test_latin - 1;

/* Some of the commonest, and some whose strokes enclose, cross and curl. */
const uint32_t mt_test_han[] =
    U"的一是不了人我在有他这为之大来以个中上们到说国和地也子时道出而要于就下得可你年生自会那后能对着事其里"
    U"所去行过家十用发天如然作方成者多日都三小军二无同么经法当起与好看学进种将还分此心前面又定见只主没公从"
    U"知使身样已很给名部正外动走意力五明间两话别手些最想开现关点被体向长问机因由头理四高情己女重新实什门气"
    U"本路水等口白老山打亲各表相马笑车思光万特世东西告望边解报服美教她真接次先风电战受许再性合命场变金工南"
    U"北原立百安林信月海死儿连反计每几记利少且应六争放听更任声带果元界指通眼色平士书令让及吃满神空目八义七"
    U"干件影式夫建内度花近何认难房位文非片早活石感始德形永字黑火土木王羊鱼鸟虫草叶黄红青蓝春夏秋冬爱龙飞雨";
const int mt_test_han_count = sizeof mt_test_han / sizeof *mt_test_han - 1;

mt_status mt_test_glyph_shape(mt_font *font, uint32_t code_point, double tolerance, mt_arena *arena,
                              mt_shape *shape) {
    mt_outline outline;
    double advance;
    mt_status status = mt_font_outline(font, mt_font_glyph(font, code_point), arena, &outline, &advance);
    return status == MT_OK ? mt_outline_shape(&outline, tolerance, arena, shape) : status;
}
