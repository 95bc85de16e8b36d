//! The functions of the crate have the values of the library: `vectors/` has what comes out of each, and `calls.rs` how
//! each is called.

mod calls;

use calls::CALLS;
use std::fs;
use std::path::Path;

/// A function's results, as numbers in which nothing is lost.
pub trait Numbers {
    fn numbers(self) -> Vec<f64>;
}

impl Numbers for f32 {
    fn numbers(self) -> Vec<f64> {
        vec![f64::from(self)]
    }
}

impl Numbers for u32 {
    fn numbers(self) -> Vec<f64> {
        vec![f64::from(self)]
    }
}

impl<const N: usize> Numbers for [f32; N] {
    fn numbers(self) -> Vec<f64> {
        self.iter().map(|&x| f64::from(x)).collect()
    }
}

impl<const N: usize> Numbers for [i32; N] {
    fn numbers(self) -> Vec<f64> {
        self.iter().map(|&x| f64::from(x)).collect()
    }
}

/// How a file of vectors calls what it holds, a setting of it, and the function, which takes the words of a row.
pub struct Call {
    pub file: &'static str,
    pub setting: &'static str,
    pub function: fn(&[u32]) -> Vec<f64>,
}

/// The text of a line between two others.
fn between<'a>(line: &'a str, start: &str, end: &str) -> Option<&'a str> {
    let behind = &line[line.find(start)? + start.len()..];
    Some(&behind[..behind.find(end)?])
}

fn numbers(text: &str) -> Vec<f64> {
    text.split(',')
        .map(|number| number.parse().unwrap())
        .collect()
}

/// How many rows a setting has, and which of them the function has other values for.
fn held(call: &Call) -> (usize, Vec<String>) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("vectors")
        .join(format!("{}.json", call.file));
    let text =
        fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let setting = format!("{{\"name\":\"{}\",\"arithmetic\":", call.setting);
    let of_setting = text
        .lines()
        .skip_while(|line| !line.trim_start().starts_with(&setting))
        .skip(1);
    let rows: Vec<&str> = of_setting
        .take_while(|line| line.contains("\"words\":\""))
        .collect();
    let wrong = rows.iter().filter(|row| {
        let words = between(row, "\"words\":\"", "\"").unwrap().split(' ');
        let words: Vec<u32> = words
            .map(|word| u32::from_str_radix(word, 16).unwrap())
            .collect();
        let expected = numbers(between(row, "\"out\":[", "]").unwrap());
        let bounds = between(row, "\"bound\":[", "]").map_or(vec![0.0; expected.len()], numbers);
        let found = (call.function)(&words);
        let near = |i: usize| (found[i] - expected[i]).abs() <= bounds[i];
        found.len() != expected.len() || !(0..found.len()).all(near)
    });
    (rows.len(), wrong.map(|row| row.to_string()).collect())
}

#[test]
fn functions_have_the_values_of_the_library() {
    for call in CALLS {
        let (rows, wrong) = held(call);
        assert!(
            rows > 40,
            "{} has {rows} rows with {}",
            call.file,
            call.setting
        );
        assert!(
            wrong.is_empty(),
            "{} with {}: {} rows, such as {}",
            call.file,
            call.setting,
            wrong.len(),
            wrong[0]
        );
    }
}

#[test]
fn a_function_that_is_wrong_is_noticed() {
    for call in CALLS.iter().step_by(7) {
        let nothing = Call {
            function: |_| vec![],
            ..*call
        };
        let (rows, wrong) = held(&nothing);
        assert_eq!(rows, wrong.len());
    }
    let lattice = Call {
        file: "hash.lattice2",
        setting: "lattice",
        function: |w| vec![f64::from(w[0])],
    };
    assert!(held(&lattice).1.len() > 40);
}

#[test]
fn a_place_is_where_it_was_made() {
    macro_rules! places {
        ($($place:ident $far:expr, $near:expr;)*) => {$(
            let half = $near.map(|_| 0.5);
            assert_eq!($place::in_cell($far, half).cell(), $far);
            assert_eq!($place::at_cell($far), $place::in_cell($far, $near.map(|_| 0.0)));
            assert_eq!($place::in_cell($near, half), $place::of($near.map(|cell| cell as f32 + 0.5)));
            assert_eq!($place::in_cell($near, half), $place::of_units($near.map(|cell| 2 * cell + 1), 1, 2));
            assert_eq!($place::of($near.map(|cell| cell as f32 + 0.5)).position(), $near.map(|cell| cell as f32 + 0.5));
            assert_eq!($place::at_cell($near).tile($near.map(|_| 4)).cell(), $near);
        )*};
    }
    macro_rules! arithmetics {
        ($($arithmetic:ident)*) => {$({
            use hashnoise::$arithmetic::{Place1, Place2, Place3, Place4};
            places! {
                Place1 [i32::MIN], [-3];
                Place2 [i32::MIN, i32::MAX], [-3, 5];
                Place3 [i32::MIN, i32::MAX, 0], [-3, 5, 0];
                Place4 [i32::MIN, i32::MAX, 0, -1], [-3, 5, 0, 7];
            }
        })*};
    }
    arithmetics!(fast fixed);
}
