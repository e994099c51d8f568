use super::{debug, outcome};

const ORACLE: &str = include_str!("../../../tests/data/function-oracle.csv");

/// Stands before each row of the table.
const DECLARATIONS: &str = "
    #declare K = 0.5;
    #declare Sphere = function{internal(61)}
    #declare Noise = function{internal(76)}
    #declare Pig = function{pigment{gradient x color_map{[0 rgb <1,.5,0>][1 rgb <0,.25,1>]}}}
    #declare Tra = function{transform{rotate 30*y translate z}}
    #declare Spl = function{spline{0,<1,2> 1,<3,5>}}
    #declare Quad = function(a,b){a*a+b*b-a*b}
    #declare Arr = array[2]
    #declare Arr[1] = Quad;
    #declare Nums = array[3]{1,2,4}
";

fn number(text: &str) -> f64 {
    match text.trim().trim_start_matches('-') {
        "nan" | "NaN" => f64::NAN,
        _ => text.trim().parse().unwrap_or_else(|_| panic!("no number: {text}")),
    }
}

#[test]
fn every_row_of_the_function_oracle() {
    let mut wrong = Vec::new();
    for line in ORACLE.lines().filter(|l| !l.starts_with('#')) {
        let fields: Vec<&str> = line.split(';').collect();
        let [function, call, expected] = fields[..] else { panic!("{line}") };
        let text = format!("{DECLARATIONS} #declare F = {function}; #debug str(F{call}, 0, 15)");
        let (found, expected) = (number(&debug(&text)), number(expected));
        let same = found == expected || (found.is_nan() && expected.is_nan());
        // Rounding may differ by a few units of the last place.
        let near = (found - expected).abs() <= 3e-14 * expected.abs().max(1.0);
        if !same && !near {
            wrong.push(format!("{function}{call} = {found}, not {expected}"));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// The message of a scene's error.
fn error(text: &str) -> String {
    match outcome(text).scene {
        Ok(_) => panic!("no error: {text}"),
        Err(e) => e.message,
    }
}

#[test]
fn errors_name_the_cause() {
    let cases = [
        ("function(x){x/0}", "division by zero"),
        ("function(x){min(x)}", "`min` takes two or more arguments"),
        ("function(x){abs(x,2)}", "`abs` takes one argument"),
        ("function(x){select(x,1)}", "`select` takes three or four arguments"),
        ("function(x){- -x}", "expected a number, a parameter or a function"),
        ("function(x){x y}", "expected `}`"),
        ("function(x){x+Missing}", "expected a number, a parameter or a function"),
        ("function(x){true}", "expected a number, a parameter or a function"),
        ("function(x){sqr(x)}", "expected a number, a parameter or a function"),
        ("function(x){V.x}", "a function's expression cannot use a vector"),
        ("function(x){S(x)}", "a function's expression cannot use a spline"),
        ("function(x){P(x,x,x)}", "expected `.` and a component"),
        ("function(x){G(x)}", "this function has 2 parameters, and 1 arguments are given"),
        ("function(V){V}", "`V` is a vector already, not a new name"),
        ("function(t){t}", "expected the name of a parameter"),
        ("function(){x}", "expected the name of a parameter"),
        ("function(x){sum(i,1,3,i)+i}", "expected a number, a parameter or a function"),
        ("function(x,y,z){pattern{gradient x}}", "a `pattern` function has no list of parameters"),
        ("function{internal(77)}", "there is no internal function 77"),
        ("function{pattern{facets}}", "`facets` is a pattern for normals only"),
        ("spline{}", "a spline has at least one point"),
    ];
    for (value, expected) in cases {
        let text = format!(
            "#declare V = <1,2,3>; #declare S = spline{{0,x 1,y}} #declare P = function{{pigment{{rgb 1}}}}
            #declare G = function(a,b){{a+b}} #declare F = {value}"
        );
        let message = error(&text);
        assert!(message.contains(expected), "{value}: {message}");
    }
}

#[test]
fn nesting_is_limited() {
    let nested = |n: usize| format!("#declare F = function(x){{{}x{}}}", "(".repeat(n), ")".repeat(n));
    assert!(error(&nested(100_000)).contains("nested"));
    assert_eq!(debug(&format!("{} #debug str(F(2),0,0)", nested(90))), "2");
}

#[test]
fn long_sums_are_no_nesting() {
    let sum = "+x*2".repeat(20_000);
    assert_eq!(debug(&format!("#declare F = function(x){{0{sum}}}; #debug str(F(0.5),0,0)")), "20000");
}

#[test]
fn functions_keep_the_values_they_were_made_with() {
    let text = "#declare K = 2; #declare F = function(x){K*x} #declare K = 7; #debug str(F(3),0,0)";
    assert_eq!(debug(text), "6");
}

#[test]
fn functions_can_be_copied_and_stored() {
    let text = "#declare F = function(a,b){a-b} #declare G = F; #declare A = array[2]
        #declare A[0] = G; #debug concat(str(G(3,1),0,0), str(A[0](5 1),0,0))";
    assert_eq!(debug(text), "24");
}

#[test]
fn splines_have_values_and_kinds() {
    let text = "#declare S = spline{0,<0,0,0> 1,<1,2,3> 3,<2,2,2> 4,<0,1,5>}
        #debug vstr(3, S(2), \" \", 0, 6)
        #debug concat(\"|\", vstr(3, S(3.5, quadratic_spline), \" \", 0, 6))
        #declare T = spline{S natural_spline}
        #debug concat(\"|\", vstr(3, T(2), \" \", 0, 6))";
    let expected = "1.500000 2.000000 2.500000|1.208333 1.583333 3.208333|2.062500 2.562500 2.500000";
    assert_eq!(debug(text), expected);
}

#[test]
fn a_spline_point_keeps_components_of_the_one_before() {
    let text = "#declare S = spline{0,<1,2,3> 1,2} #debug vstr(3, S(1), \" \", 0, 0)";
    assert_eq!(debug(text), "2 2 3");
}

#[test]
fn the_scene_s_generator_counts_where_a_function_is_called() {
    let text = "#declare N = function{internal(76)}
        global_settings{noise_generator 3} #debug str(N(.1,.2,.3),0,9)
        global_settings{noise_generator 2} #debug concat(\" \", str(N(.1,.2,.3),0,9))";
    assert_eq!(debug(text), "0.652260854 0.417192033");
}
