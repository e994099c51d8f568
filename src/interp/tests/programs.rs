//! Replayed expressions are compiled: every pass must give what the first one, read as usual, gives.

use super::{debug, outcome};

/// What an expression prints in the passes of a loop; `setup` comes before the loop and may be changed by
/// `step` in it.
fn passes(setup: &str, expression: &str, step: &str) -> Vec<String> {
    let text = format!("{setup} #for (K,1,4) #debug concat(str({expression},0,12),\";\") {step} #end");
    debug(&text).split_terminator(';').map(str::to_owned).collect()
}

#[test]
fn every_pass_gives_the_same_value() {
    let setup = "#declare A=3; #declare B=-2.5; #declare V=<1,2,3>; #declare C=rgb <.1,.2,.3>; \
                 #declare N=array[2][2]{{1,2},{3,4}}; #declare W=array[2]{x,<4,5,6>}; \
                 #declare M=array[1]{N} #declare F=function(q){q*2} #declare S=\"s\"";
    for expression in [
        "A+B*2-A/B",
        "-A*-B",
        "!A+!0",
        "(A<B)+(A>=B)*2+(A=3)*4+(A!=B)*8",
        "(A&B|0)",
        "(0&0|1)",
        "(A>0?B:A)",
        "(0?2:1?5:6)",
        "sin(A)+cos(B)*tan(1)",
        "sin(A<B)",
        "sqrt(A)+ln(A)+log(A)+acos(.1)+asin(.2)",
        "pow(A,2)+atan2(A,B)+mod(A,2)+div(7,-2)",
        "max(A,B,7)+min(A,B,-9)",
        "V.y+C.blue+V.x*2",
        "N[1][0]+N[A-2][1]",
        "W[1].z+W[0].x",
        "M[0][1][1]",
        "pi*2+true+no+clock",
        "int(B)+abs(B)+floor(B)+ceil(B)",
        "F(A)+1",
        "strlen(S)+A",
        "vlength(V)+A",
        "(V*2).x",
        "((((A))))",
        "A+#if (1) 2 #else 3 #end*2",
        "select(A,1,2,3)",
        "1e300*1e300",
    ] {
        let all = passes(setup, expression, "");
        assert_eq!(all.len(), 4, "{expression}");
        assert!(all.iter().all(|v| *v == all[0]), "{expression}: {all:?}");
    }
}

#[test]
fn names_may_change_their_meaning_between_passes() {
    let numbers = passes("#declare A=1;", "A", "#declare A=A*10;");
    assert_eq!(numbers, ["1.000000000000", "10.000000000000", "100.000000000000", "1000.000000000000"]);
    let text = "#declare A=1; #for (K,1,4) #debug str(A+K,0,0) #if (K=3) #declare A=array[1]{5}; #end #end";
    assert!(super::error(text).contains("array"));
}

#[test]
fn a_macro_behind_an_expression_may_continue_it() {
    let text = "#macro P() +1 #end #for (K,1,4) #declare V=<K P(), 2>; #debug str(V.x,0,0) #end";
    assert_eq!(debug(text), "2345");
    let text = "#macro P() 1+ #end #macro Q() K #end #for (K,1,3) #debug str((P() Q()),0,0) #end";
    assert_eq!(debug(text), "234");
}

#[test]
fn warnings_and_errors_come_from_compiled_expressions_too() {
    let warned = outcome("#declare D=2; #for (K,1,4) #declare D=D-1; #declare Q=1/D; #debug str(Q,0,1) #end");
    assert_eq!(warned.debug, "1.0inf-1.0-0.5");
    assert_eq!(warned.warnings.iter().filter(|w| w.message.contains("division")).count(), 1);
    let error =
        outcome("#declare D=3; #for (K,1,5) #declare D=D-1; #declare Q=sqrt(D); #end").scene.unwrap_err();
    assert!(error.message.contains("sqrt(-1)"));
}

#[test]
fn parameters_by_reference_are_read_through() {
    let text = "#macro Add(P,Q) #for (K,1,4) #declare P=P+Q; #end #end #declare A=1; #declare B=array[1]{2}; Add(A,B[0]) \
                Add(B[0],A) #debug concat(str(A,0,0),\" \",str(B[0],0,0))";
    assert_eq!(debug(text), "9 38");
}

#[test]
fn random_numbers_are_drawn_once_each() {
    let text = "#declare R=seed(1); #for (K,1,4) #debug concat(str(rand(R)*2+K*0,0,6),\" \") #end";
    assert_eq!(debug(text), "0.843986 0.974242 1.331792 1.951464 ");
}

/// Assignments and conditions in kept text take a short way where they can; it must do what the long one does.
#[test]
fn assignments_and_conditions_of_every_kind_in_kept_text() {
    let cases = [
        // A local of the macro hides the global name; `#declare` changes what is visible.
        ("#declare G=0; #macro M() #local G=G+1; #declare G=G*2; #debug str(G,0,0) #end M() M() M()", "222"),
        ("#declare G=1; #macro M() #declare G=G*2; #end M() M() M() #debug str(G,0,0)", "8"),
        // A number becomes a vector and a number again.
        (
            "#declare A=1; #for (K,1,4) #declare A=A*2; #declare A=A*<1,2>; #declare A=A.y; #debug str(A,0,0) #end",
            "41664256",
        ),
        // A missing value behind the first passes: an array takes the name.
        (
            "#declare S=\"\"; #declare A=0; #while (A<3) #declare A=A+1; #declare S=concat(S,\"i\"); #end #debug S",
            "iii",
        ),
        // The condition's program ends where a comparison of strings begins.
        (
            "#declare S=\"b\"; #for (K,1,3) #if (S>\"a\") #debug \"y\" #end #if ((K>1)&(K<3)) #debug \"2\" #end #end",
            "yy2y",
        ),
        // `#local` in a loop of the main text is global.
        ("#for (K,1,3) #local L=K; #end #debug str(L,0,0)", "3"),
    ];
    for (text, expected) in cases {
        assert_eq!(debug(text), expected, "{text}");
    }
    assert!(super::error("#for (K,1,3) #declare A=K , #end").contains(';'));
    let said =
        outcome("#declare deprecated \"old\" X=3; #declare Y=0; #for (K,1,3) #declare Y=X; #end").warnings;
    assert_eq!(said.iter().filter(|w| w.message == "old").count(), 1);
}
