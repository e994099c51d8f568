//! Dates, by the rules of C's `strftime` in its plain locale and UTC.

use super::query::EPOCH;

const DAYS: [&str; 7] = ["Sunday", "Monday", "Tuesday", "Wednesday", "Thursday", "Friday", "Saturday"];
const MONTHS: [&str; 12] = [
    "January",
    "February",
    "March",
    "April",
    "May",
    "June",
    "July",
    "August",
    "September",
    "October",
    "November",
    "December",
];

/// A moment taken apart. Months and week days count from 0, days of the month and year from 1.
struct Date {
    seconds: i64,
    year: i64,
    month: usize,
    day: i64,
    day_of_year: i64,
    weekday: i64,
    hour: i64,
    minute: i64,
    second: i64,
}

impl Date {
    /// From seconds since 1970.
    fn new(seconds: i64) -> Self {
        let (days, rest) = (seconds.div_euclid(86_400), seconds.rem_euclid(86_400));
        // Days since 0000-03-01, in eras of 400 years (146097 days).
        let shifted = days + 719_468;
        let (era, of_era) = (shifted.div_euclid(146_097), shifted.rem_euclid(146_097));
        let year_of_era = (of_era - of_era / 1460 + of_era / 36_524 - of_era / 146_096) / 365;
        let from_march = of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
        let month_from_march = (5 * from_march + 2) / 153;
        let day = from_march - (153 * month_from_march + 2) / 5 + 1;
        let month = (month_from_march + 2) % 12;
        let year = era * 400 + year_of_era + i64::from(month < 2);
        let leap = (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
        let before = [0, 31, 59, 90, 120, 151, 181, 212, 243, 273, 304, 334];
        let day_of_year = before[month as usize] + i64::from(leap && month > 1) + day;
        Self {
            seconds,
            year,
            month: month as usize,
            day,
            day_of_year,
            weekday: (days + 4).rem_euclid(7),
            hour: rest / 3600,
            minute: rest / 60 % 60,
            second: rest % 60,
        }
    }

    /// Hour on a twelve-hour face.
    fn hour12(&self) -> i64 {
        (self.hour + 11) % 12 + 1
    }

    /// ISO 8601 year and week.
    fn iso_week(&self) -> (i64, i64) {
        let from_monday = (self.weekday + 6) % 7;
        let week = (self.day_of_year - 1 - from_monday + 10) / 7;
        let last = |year: i64| {
            let starts = |y: i64| (y + y / 4 - y / 100 + y / 400).rem_euclid(7);
            52 + i64::from(starts(year) == 4 || starts(year - 1) == 3)
        };
        if week < 1 {
            (self.year - 1, last(self.year - 1))
        } else if week > last(self.year) {
            (self.year + 1, 1)
        } else {
            (self.year, week)
        }
    }

    /// What one letter behind `%` stands for; `None` if it stands for nothing.
    fn field(&self, letter: char) -> Option<String> {
        let weekday = DAYS[self.weekday as usize];
        let month = MONTHS[self.month];
        Some(match letter {
            'Y' => self.year.to_string(),
            'C' => format!("{:02}", self.year.div_euclid(100)),
            'y' => format!("{:02}", self.year.rem_euclid(100)),
            'm' => format!("{:02}", self.month + 1),
            'd' => format!("{:02}", self.day),
            'e' => format!("{:2}", self.day),
            'H' => format!("{:02}", self.hour),
            'I' => format!("{:02}", self.hour12()),
            'M' => format!("{:02}", self.minute),
            'S' => format!("{:02}", self.second),
            'j' => format!("{:03}", self.day_of_year),
            'p' => if self.hour < 12 { "AM" } else { "PM" }.to_owned(),
            'a' => weekday[..3].to_owned(),
            'A' => weekday.to_owned(),
            'b' | 'h' => month[..3].to_owned(),
            'B' => month.to_owned(),
            'u' => ((self.weekday + 6) % 7 + 1).to_string(),
            'w' => self.weekday.to_string(),
            'U' => format!("{:02}", (self.day_of_year + 6 - self.weekday) / 7),
            'W' => format!("{:02}", (self.day_of_year + 6 - (self.weekday + 6) % 7) / 7),
            'G' => self.iso_week().0.to_string(),
            'g' => format!("{:02}", self.iso_week().0.rem_euclid(100)),
            'V' => format!("{:02}", self.iso_week().1),
            's' => self.seconds.to_string(),
            'Z' => "GMT".to_owned(),
            'z' => "+0000".to_owned(),
            'n' => "\n".to_owned(),
            't' => "\t".to_owned(),
            '%' => "%".to_owned(),
            _ => return None,
        })
    }
}

/// Shorthands for several fields.
fn expansion(letter: char) -> Option<&'static str> {
    Some(match letter {
        'D' | 'x' => "%m/%d/%y",
        'F' => "%Y-%m-%d",
        'T' | 'X' => "%H:%M:%S",
        'R' => "%H:%M",
        'r' => "%I:%M:%S %p",
        'c' => "%a %b %e %H:%M:%S %Y",
        _ => return None,
    })
}

/// Whether the moment `days` after 2000-01-01 is one of the years 1400 to 9999.
pub(in crate::interp) fn has_date(days: f64) -> bool {
    (-219_145.0..2_921_940.0).contains(&days)
}

/// The moment `days` after 2000-01-01, written by `format`.
pub(in crate::interp) fn format_date(days: f64, format: &str) -> String {
    write(&Date::new((days * 86_400.0 + EPOCH + 0.5).floor() as i64 % (1 << 50)), format)
}

fn write(date: &Date, format: &str) -> String {
    let mut out = String::new();
    let mut letters = format.chars();
    while let Some(c) = letters.next() {
        if c != '%' {
            out.push(c);
            continue;
        }
        let Some(letter) = letters.next() else {
            out.push('%');
            break;
        };
        match (date.field(letter), expansion(letter)) {
            (Some(field), _) => out.push_str(&field),
            (None, Some(long)) => out.push_str(&write(date, long)),
            (None, None) => out.extend(['%', letter]),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::format_date;

    #[test]
    fn days_count_from_the_year_2000() {
        assert_eq!(format_date(0.0, "%Y-%m-%d %H:%M:%SZ"), "2000-01-01 00:00:00Z");
        assert_eq!(format_date(5000.5, "%Y/%j %H"), "2013/252 12");
        assert_eq!(format_date(59.0, "%a %d %b"), "Tue 29 Feb");
        assert_eq!(format_date(-1.0, "%F %A %G-W%V"), "1999-12-31 Friday 1999-W52");
        assert_eq!(format_date(366.0, "%D %j %U"), "01/01/01 001 00");
    }
}
