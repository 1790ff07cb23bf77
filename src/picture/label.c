/* Each character is a few polylines on a grid: cap height 6, x-height 4, descenders down to -2. A point is
 * two letters, x as a digit and y as a digit, or 'y' for -1 and 'z' for -2; a blank lifts the pen; a point
 * twice is a dot. */
#include "picture/label.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>

#define CAP_HEIGHT 6
#define SPACING 2 /* between the widest point of a character and the next one */
#define BLANK 2   /* the width of a space */
#define DOT_HEIGHT 0.3

static const char *const strokes[] = {
    "",                                 /* space */
    "0602 0000",                        /* ! */
    "0604 2624",                        /* " */
    "1016 3036 0242 0444",              /* # */
    "011030414233130405163645 2y27",    /* $ */
    "0046 0506161505 3031414030",       /* % */
    "4014152635340201102042",           /* & */
    "0604",                             /* ' */
    "1705011y",                         /* ( */
    "0715110y",                         /* ) */
    "2125 0244 0442",                   /* * */
    "2125 0343",                        /* + */
    "100y",                             /* , */
    "0333",                             /* - */
    "0000",                             /* . */
    "0036",                             /* / */
    "103041453616050110",               /* 0 */
    "051610 0020",                      /* 1 */
    "05163645440040",                   /* 2 */
    "051636454433 13334241301001",      /* 3 */
    "30360242",                         /* 4 */
    "460603334241301001",               /* 5 */
    "453616050110304142331302",         /* 6 */
    "064610",                           /* 7 */
    "13040516364544331302011030414233", /* 8 */
    "011030414536160504133344",         /* 9 */
    "0000 0303",                        /* : */
    "100y 1313",                        /* ; */
    "350331",                           /* < */
    "0242 0444",                        /* = */
    "053301",                           /* > */
    "05163645442322 2020",              /* ? */
    "4010010516364542323424132232",     /* @ */
    "0004264440 0242",                  /* A */
    "00063645443303 3342413000",        /* B */
    "4536160501103041",                 /* C */
    "00062644422000",                   /* D */
    "46060040 0333",                    /* E */
    "460600 0333",                      /* F */
    "45361605011030414323",             /* G */
    "0006 4046 0343",                   /* H */
    "0626 1610 0020",                   /* I */
    "3631201001",                       /* J */
    "0006 4602 1340",                   /* K */
    "060040",                           /* L */
    "0006234640",                       /* M */
    "00064046",                         /* N */
    "103041453616050110",               /* O */
    "00063645443303",                   /* P */
    "103041453616050110 2240",          /* Q */
    "00063645443303 2340",              /* R */
    "011030414233130405163645",         /* S */
    "0646 2620",                        /* T */
    "060110304146",                     /* U */
    "062046",                           /* V */
    "0610233046",                       /* W */
    "0046 0640",                        /* X */
    "0623 4623 2320",                   /* Y */
    "06460040",                         /* Z */
    "17070y1y",                         /* [ */
    "0630",                             /* \ */
    "07171y0y",                         /* ] */
    "042644",                           /* ^ */
    "0y4y",                             /* _ */
    "0615",                             /* ` */
    "0424333010011232",                 /* a */
    "06002031332404",                   /* b */
    "341403011030",                     /* c */
    "36301001031434",                   /* d */
    "023233241403011030",               /* e */
    "261510 0424",                      /* f */
    "341403011030 343y2z0z",            /* g */
    "0600 04243330",                    /* h */
    "0400 0606",                        /* i */
    "141y0z 1616",                      /* j */
    "0600 3401 1230",                   /* k */
    "060110",                           /* l */
    "0400 04142320 23344340",           /* m */
    "0400 04243330",                    /* n */
    "102031332414030110",               /* o */
    "040z 042433312000",                /* p */
    "343z 341403011030",                /* q */
    "0400 031424",                      /* r */
    "3414031222312000",                 /* s */
    "161120 0424",                      /* t */
    "04011030 3430",                    /* u */
    "042044",                           /* v */
    "0410233044",                       /* w */
    "0034 0430",                        /* x */
    "04011030 343y2z0z",                /* y */
    "04340030",                         /* z */
    "2716140312102y",                   /* { */
    "070y",                             /* | */
    "0716142312100y",                   /* } */
    "03143344",                         /* ~ */
};

static const char *strokes_of(unsigned char letter) {
    return letter < ' ' || letter > '~' ? "0006363000" : strokes[letter - ' '];
}

/* The bytes of a UTF-8 character after its first. */
static int is_continuation(char byte) {
    return ((unsigned char)byte & 0xc0) == 0x80;
}

static int width_of(const char *polylines) {
    int width = *polylines ? 0 : BLANK;
    for (const char *p = polylines; *p; p += *p == ' ' ? 1 : 2)
        if (*p != ' ' && *p - '0' > width) width = *p - '0';
    return width;
}

/* Adds a character's polylines to the path. */
static void add_letter(cairo_t *cairo, const char *polylines, double x, double y, double unit) {
    const char *before = "  ";
    for (const char *p = polylines; *p; p += *p == ' ' ? 1 : 2) {
        if (*p == ' ' || p == polylines) cairo_new_sub_path(cairo);
        if (*p == ' ') continue;
        double row = p[1] == 'y' ? -1 : p[1] == 'z' ? -2 : p[1] - '0';
        bool is_dot = before[0] == p[0] && before[1] == p[1];
        cairo_line_to(cairo, x + (*p - '0') * unit, y - (row + (is_dot ? DOT_HEIGHT : 0)) * unit);
        before = p;
    }
}

void mt_label_draw(cairo_t *cairo, const char *text, double x, double y, double height) {
    double unit = height / CAP_HEIGHT;
    cairo_new_path(cairo);
    for (; *text; text++) {
        if (is_continuation(*text)) continue;
        const char *polylines = strokes_of((unsigned char)*text);
        add_letter(cairo, polylines, x, y, unit);
        x += (width_of(polylines) + SPACING) * unit;
    }
    cairo_save(cairo);
    cairo_set_line_width(cairo, 0.7 * unit);
    cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    cairo_stroke(cairo);
    cairo_restore(cairo);
}

void mt_label_draw_centred(cairo_t *cairo, const char *text, double x, double y, double height) {
    mt_label_draw(cairo, text, x - mt_label_width(text, height) / 2, y, height);
}

double mt_label_width(const char *text, double height) {
    int width = 0;
    for (; *text; text++)
        if (!is_continuation(*text)) width += width_of(strokes_of((unsigned char)*text)) + SPACING;
    return width == 0 ? 0 : (width - SPACING) * height / CAP_HEIGHT;
}

double mt_label_fitting(const char *text, double height, double room) {
    double width = mt_label_width(text, height);
    return width > room ? height * room / width : height;
}

/* What stands before it, and T, which may be less than nothing. */
static size_t write_t(const char *before, double t, char *text, size_t room) {
    int decimals = 4, one = 10000, value = (int)(fabs(t) * one + 0.5);
    const char *sign = t < 0 && value ? "-" : "";
    for (; decimals > 0 && value % 10 == 0; decimals--, one /= 10) value /= 10;
    int length = decimals == 0
                     ? snprintf(text, room, "%s%s%d", before, sign, value)
                     : snprintf(text, room, "%s%s%d.%0*d", before, sign, value / one, decimals, value % one);
    return (size_t)length < room ? (size_t)length : room;
}

void mt_label_t(double t, char *text, size_t room) {
    write_t("T = ", t, text, room);
}

void mt_label_at(mt_at at, char *text, size_t room) {
    size_t length = write_t("T = ", at.x, text, room);
    if (at.x != at.y) write_t(",y=", at.y, text + length, room - length);
}

double mt_label_height(double size) {
    double height = size / 10;
    return height < 7 ? 7 : height > 16 ? 16 : height;
}
