const bg="uplot",yg="u-hz",Mg="u-vt",Sg="u-title",wg="u-wrap",Eg="u-under",Tg="u-over",Ag="u-axis",Is="u-off",Rg="u-select",Cg="u-cursor-x",Pg="u-cursor-y",Lg="u-cursor-pt",Ng="u-legend",Dg="u-live",Ig="u-inline",Ug="u-series",kg="u-marker",wu="u-label",Fg="u-value",mr="width",gr="height";const Eu="bottom",co="left",gl="right",vh="#000",Tu=vh+"0",_l="mousemove",Au="mousedown",vl="mouseup",Ru="mouseenter",Cu="mouseleave",Pu="dblclick",Og="resize",Bg="scroll",Lu="change",Ra="dppxchange",xh="--",jo=typeof window<"u",hc=jo?document:null,Lo=jo?window:null,zg=jo?navigator:null;let Se,Hr;function uc(){let i=devicePixelRatio;Se!=i&&(Se=i,Hr&&fc(Lu,Hr,uc),Hr=matchMedia(`(min-resolution: ${Se-.001}dppx) and (max-resolution: ${Se+.001}dppx)`),zs(Lu,Hr,uc),Lo.dispatchEvent(new CustomEvent(Ra)))}function Fn(i,t){if(t!=null){let e=i.classList;!e.contains(t)&&e.add(t)}}function dc(i,t){let e=i.classList;e.contains(t)&&e.remove(t)}function ke(i,t,e){i.style[t]=e+"px"}function ii(i,t,e,n){let s=hc.createElement(i);return t!=null&&Fn(s,t),e?.insertBefore(s,n),s}function Xn(i,t){return ii("div",i,t)}const Nu=new WeakMap;function _i(i,t,e,n,s){let o="translate("+t+"px,"+e+"px)",a=Nu.get(i);o!=a&&(i.style.transform=o,Nu.set(i,o),t<0||e<0||t>n||e>s?Fn(i,Is):dc(i,Is))}const Du=new WeakMap;function Iu(i,t,e){let n=t+e,s=Du.get(i);n!=s&&(Du.set(i,n),i.style.background=t,i.style.borderColor=e)}const Uu=new WeakMap;function ku(i,t,e,n){let s=t+""+e,o=Uu.get(i);s!=o&&(Uu.set(i,s),i.style.height=e+"px",i.style.width=t+"px",i.style.marginLeft=n?-t/2+"px":0,i.style.marginTop=n?-e/2+"px":0)}const bh={passive:!0},Hg={...bh,capture:!0};function zs(i,t,e,n){t.addEventListener(i,e,n?Hg:bh)}function fc(i,t,e,n){t.removeEventListener(i,e,bh)}jo&&uc();function oi(i,t,e,n){let s;e=e||0,n=n||t.length-1;let o=n<=2147483647;for(;n-e>1;)s=o?e+n>>1:zn((e+n)/2),t[s]<i?e=s:n=s;return i-t[e]<=t[n]-i?e:n}function np(i){return(e,n,s)=>{let o=-1,a=-1;for(let r=n;r<=s;r++)if(i(e[r])){o=r;break}for(let r=s;r>=n;r--)if(i(e[r])){a=r;break}return[o,a]}}const ip=i=>i!=null,sp=i=>i!=null&&i>0,Ga=np(ip),Vg=np(sp);function Gg(i,t,e,n=0,s=!1){let o=s?Vg:Ga,a=s?sp:ip;[t,e]=o(i,t,e);let r=i[t],l=i[t];if(t>-1)if(n==1)r=i[t],l=i[e];else if(n==-1)r=i[e],l=i[t];else for(let c=t;c<=e;c++){let h=i[c];a(h)&&(h<r?r=h:h>l&&(l=h))}return[r??Pe,l??-Pe]}function Wa(i,t,e,n){let s=Bu(i),o=Bu(t);i==t&&(s==-1?(i*=e,t/=e):(i/=e,t*=e));let a=e==10?zi:op,r=s==1?zn:jn,l=o==1?jn:zn,c=r(a(Je(i))),h=l(a(Je(t))),u=Uo(e,c),d=Uo(e,h);return e==10&&(c<0&&(u=Le(u,-c)),h<0&&(d=Le(d,-h))),n||e==2?(i=u*s,t=d*o):(i=cp(i,u),t=$a(t,d)),[i,t]}function yh(i,t,e,n){let s=Wa(i,t,e,n);return i==0&&(s[0]=0),t==0&&(s[1]=0),s}const Mh=.1,Fu={mode:3,pad:Mh},yr={pad:0,soft:null,mode:0},Wg={min:yr,max:yr};function Ca(i,t,e,n){return qa(e)?Ou(i,t,e):(yr.pad=e,yr.soft=n?0:null,yr.mode=n?3:0,Ou(i,t,Wg))}function be(i,t){return i??t}function $g(i,t,e){for(t=be(t,0),e=be(e,i.length-1);t<=e;){if(i[t]!=null)return!0;t++}return!1}function Ou(i,t,e){let n=e.min,s=e.max,o=be(n.pad,0),a=be(s.pad,0),r=be(n.hard,-Pe),l=be(s.hard,Pe),c=be(n.soft,Pe),h=be(s.soft,-Pe),u=be(n.mode,0),d=be(s.mode,0),p=t-i,_=zi(p),g=wn(Je(i),Je(t)),m=zi(g),f=Je(m-_);(p<1e-24||f>10)&&(p=0,(i==0||t==0)&&(p=1e-24,u==2&&c!=Pe&&(o=0),d==2&&h!=-Pe&&(a=0)));let M=p||g||1e3,S=zi(M),x=Uo(10,zn(S)),F=M*(p==0?i==0?.1:1:o),L=Le(cp(i-F,x/10),24),A=i>=c&&(u==1||u==3&&L<=c||u==2&&L>=c)?c:Pe,D=wn(r,L<A&&i>=A?A:ri(A,L)),E=M*(p==0?t==0?.1:1:a),b=Le($a(t+E,x/10),24),R=t<=h&&(d==1||d==3&&b>=h||d==2&&b<=h)?h:-Pe,H=ri(l,b>R&&t<=R?R:wn(R,b));return D==H&&D==0&&(H=100),[D,H]}const qg=new Intl.NumberFormat(jo?zg.language:"en-US"),Sh=i=>qg.format(i),Hn=Math,_a=Hn.PI,Je=Hn.abs,zn=Hn.floor,Ke=Hn.round,jn=Hn.ceil,ri=Hn.min,wn=Hn.max,Uo=Hn.pow,Bu=Hn.sign,zi=Hn.log10,op=Hn.log2,Xg=(i,t=1)=>Hn.sinh(i)*t,xl=(i,t=1)=>Hn.asinh(i/t),Pe=1/0;function zu(i){return(zi((i^i>>31)-(i>>31))|0)+1}function pc(i,t,e){return ri(wn(i,t),e)}function rp(i){return typeof i=="function"}function le(i){return rp(i)?i:()=>i}const jg=()=>{},ap=i=>i,lp=(i,t)=>t,Yg=i=>null,Hu=i=>!0,Vu=(i,t)=>i==t,Kg=/\.\d*?(?=9{6,}|0{6,})/gm,Ws=i=>{if(up(i)||us.has(i))return i;const t=`${i}`,e=t.match(Kg);if(e==null)return i;let n=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,o]=t.split("e");return+`${Ws(s)}e${o}`}return Le(i,n)};function Ls(i,t){return Ws(Le(Ws(i/t))*t)}function $a(i,t){return Ws(jn(Ws(i/t))*t)}function cp(i,t){return Ws(zn(Ws(i/t))*t)}function Le(i,t=0){if(up(i))return i;let e=10**t,n=i*e*(1+Number.EPSILON);return Ke(n)/e}const us=new Map;function hp(i){return((""+i).split(".")[1]||"").length}function Er(i,t,e,n){let s=[],o=n.map(hp);for(let a=t;a<e;a++){let r=Je(a),l=Le(Uo(i,a),r);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${a}`:n[c]*l,u=(a>=0?0:r)+(a>=o[c]?0:o[c]),d=i==10?h:Le(h,u);s.push(d),us.set(d,u)}}return s}const Mr={},wh=[],ko=[null,null],ss=Array.isArray,up=Number.isInteger,Zg=i=>i===void 0;function Gu(i){return typeof i=="string"}function qa(i){let t=!1;if(i!=null){let e=i.constructor;t=e==null||e==Object}return t}function Jg(i){return i!=null&&typeof i=="object"}const Qg=Object.getPrototypeOf(Uint8Array),dp="__proto__";function Fo(i,t=qa){let e;if(ss(i)){let n=i.find(s=>s!=null);if(ss(n)||t(n)){e=Array(i.length);for(let s=0;s<i.length;s++)e[s]=Fo(i[s],t)}else e=i.slice()}else if(i instanceof Qg)e=i.slice();else if(t(i)){e={};for(let n in i)n!=dp&&(e[n]=Fo(i[n],t))}else e=i;return e}function Xe(i){let t=arguments;for(let e=1;e<t.length;e++){let n=t[e];for(let s in n)s!=dp&&(qa(i[s])?Xe(i[s],Fo(n[s])):i[s]=Fo(n[s]))}return i}const t0=0,e0=1,n0=2;function i0(i,t,e){for(let n=0,s,o=-1;n<t.length;n++){let a=t[n];if(a>o){for(s=a-1;s>=0&&i[s]==null;)i[s--]=null;for(s=a+1;s<e&&i[s]==null;)i[o=s++]=null}}}function s0(i,t){if(a0(i)){let a=i[0].slice();for(let r=1;r<i.length;r++)a.push(...i[r].slice(1));return l0(a[0])||(a=r0(a)),a}let e=new Set;for(let a=0;a<i.length;a++){let l=i[a][0],c=l.length;for(let h=0;h<c;h++)e.add(l[h])}let n=[Array.from(e).sort((a,r)=>a-r)],s=n[0].length,o=new Map;for(let a=0;a<s;a++)o.set(n[0][a],a);for(let a=0;a<i.length;a++){let r=i[a],l=r[0];for(let c=1;c<r.length;c++){let h=r[c],u=Array(s).fill(void 0),d=t?t[a][c]:e0,p=[];for(let _=0;_<h.length;_++){let g=h[_],m=o.get(l[_]);g===null?d!=t0&&(u[m]=g,d==n0&&p.push(m)):u[m]=g}i0(u,p,s),n.push(u)}}return n}const o0=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function r0(i){let t=i[0],e=t.length,n=Array(e);for(let o=0;o<n.length;o++)n[o]=o;n.sort((o,a)=>t[o]-t[a]);let s=[];for(let o=0;o<i.length;o++){let a=i[o],r=Array(e);for(let l=0;l<e;l++)r[l]=a[n[l]];s.push(r)}return s}function a0(i){let t=i[0][0],e=t.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=e)return!1;if(s!=t){for(let o=0;o<e;o++)if(s[o]!=t[o])return!1}}return!0}function l0(i,t=100){const e=i.length;if(e<=1)return!0;let n=0,s=e-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;const o=wn(1,zn((s-n+1)/t));for(let a=i[n],r=n+o;r<=s;r+=o){const l=i[r];if(l!=null){if(l<=a)return!1;a=l}}return!0}const fp=["January","February","March","April","May","June","July","August","September","October","November","December"],pp=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function mp(i){return i.slice(0,3)}const c0=pp.map(mp),h0=fp.map(mp),u0={MMMM:fp,MMM:h0,WWWW:pp,WWW:c0};function ar(i){return(i<10?"0":"")+i}function d0(i){return(i<10?"00":i<100?"0":"")+i}const f0={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,t)=>t.MMMM[i.getMonth()],MMM:(i,t)=>t.MMM[i.getMonth()],MM:i=>ar(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>ar(i.getDate()),D:i=>i.getDate(),WWWW:(i,t)=>t.WWWW[i.getDay()],WWW:(i,t)=>t.WWW[i.getDay()],HH:i=>ar(i.getHours()),H:i=>i.getHours(),h:i=>{let t=i.getHours();return t==0?12:t>12?t-12:t},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>ar(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>ar(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>d0(i.getMilliseconds())};function Eh(i,t){t=t||u0;let e=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)e.push(s[0][0]=="{"?f0[s[1]]:s[0]);return o=>{let a="";for(let r=0;r<e.length;r++)a+=typeof e[r]=="string"?e[r]:e[r](o,t);return a}}const p0=new Intl.DateTimeFormat().resolvedOptions().timeZone;function m0(i,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+i+i.getTimezoneOffset()*6e4):t==p0?e=i:(e=new Date(i.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(i.getMilliseconds())),e}const gp=i=>i%1==0,Pa=[1,2,2.5,5],g0=Er(10,-32,0,Pa),_p=Er(10,0,32,Pa),_0=_p.filter(gp),Ns=g0.concat(_p),Th=`
`,vp="{YYYY}",Wu=Th+vp,xp="{M}/{D}",_r=Th+xp,Vr=_r+"/{YY}",bp="{aa}",v0="{h}:{mm}",Ro=v0+bp,$u=Th+Ro,qu=":{ss}",Ee=null;function yp(i){let t=i*1e3,e=t*60,n=e*60,s=n*24,o=s*30,a=s*365,l=(i==1?Er(10,0,3,Pa).filter(gp):Er(10,-3,0,Pa)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,o,o*2,o*3,o*4,o*6,a,a*2,a*5,a*10,a*25,a*50,a*100]);const c=[[a,vp,Ee,Ee,Ee,Ee,Ee,Ee,1],[s*28,"{MMM}",Wu,Ee,Ee,Ee,Ee,Ee,1],[s,xp,Wu,Ee,Ee,Ee,Ee,Ee,1],[n,"{h}"+bp,Vr,Ee,_r,Ee,Ee,Ee,1],[e,Ro,Vr,Ee,_r,Ee,Ee,Ee,1],[t,qu,Vr+" "+Ro,Ee,_r+" "+Ro,Ee,$u,Ee,1],[i,qu+".{fff}",Vr+" "+Ro,Ee,_r+" "+Ro,Ee,$u,Ee,1]];function h(u){return(d,p,_,g,m,f)=>{let M=[],S=m>=a,x=m>=o&&m<a,F=u(_),L=Le(F*i,3),A=bl(F.getFullYear(),S?0:F.getMonth(),x||S?1:F.getDate()),D=Le(A*i,3);if(x||S){let E=x?m/o:0,b=S?m/a:0,R=L==D?L:Le(bl(A.getFullYear()+b,A.getMonth()+E,1)*i,3),H=new Date(Ke(R/i)),O=H.getFullYear(),q=H.getMonth();for(let $=0;R<=g;$++){let X=bl(O+b*$,q+E*$,1),j=X-u(Le(X*i,3));R=Le((+X+j)*i,3),R<=g&&M.push(R)}}else{let E=m>=s?s:m,b=zn(_)-zn(L),R=D+b+$a(L-D,E);M.push(R);let H=u(R),O=H.getHours()+H.getMinutes()/e+H.getSeconds()/n,q=m/n,$=d.axes[p]._space,X=f/$;for(;R=Le(R+m,i==1?0:3),!(R>g);)if(q>1){let j=zn(Le(O+q,6))%24,lt=u(R).getHours()-j;lt>1&&(lt=-1),R-=lt*n,O=(O+q)%24;let gt=M[M.length-1];Le((R-gt)/m,3)*X>=.7&&M.push(R)}else M.push(R)}return M}}return[l,c,h]}const[x0,b0,y0]=yp(1),[M0,S0,w0]=yp(.001);Er(2,-53,53,[1]);function Xu(i,t){return i.map(e=>e.map((n,s)=>s==0||s==8||n==null?n:t(s==1||e[8]==0?n:e[1]+n)))}function ju(i,t){return(e,n,s,o,a)=>{let r=t.find(_=>a>=_[0])||t[t.length-1],l,c,h,u,d,p;return n.map(_=>{let g=i(_),m=g.getFullYear(),f=g.getMonth(),M=g.getDate(),S=g.getHours(),x=g.getMinutes(),F=g.getSeconds(),L=m!=l&&r[2]||f!=c&&r[3]||M!=h&&r[4]||S!=u&&r[5]||x!=d&&r[6]||F!=p&&r[7]||r[1];return l=m,c=f,h=M,u=S,d=x,p=F,L(g)})}}function E0(i,t){let e=Eh(t);return(n,s,o,a,r)=>s.map(l=>e(i(l)))}function bl(i,t,e){return new Date(i,t,e)}function Yu(i,t){return t(i)}const T0="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Ku(i,t){return(e,n,s,o)=>o==null?xh:t(i(n))}function A0(i,t){let e=i.series[t];return e.width?e.stroke(i,t):e.points.width?e.points.stroke(i,t):null}function R0(i,t){return i.series[t].fill(i,t)}const C0={show:!0,live:!0,isolate:!1,mount:jg,markers:{show:!0,width:2,stroke:A0,fill:R0,dash:"solid"},idx:null,idxs:null,values:[]};function P0(i,t){let e=i.cursor.points,n=Xn(),s=e.size(i,t);ke(n,mr,s),ke(n,gr,s);let o=s/-2;ke(n,"marginLeft",o),ke(n,"marginTop",o);let a=e.width(i,t,s);return a&&ke(n,"borderWidth",a),n}function L0(i,t){let e=i.series[t].points;return e._fill||e._stroke}function N0(i,t){let e=i.series[t].points;return e._stroke||e._fill}function D0(i,t){return i.series[t].points.size}const yl=[0,0];function I0(i,t,e){return yl[0]=t,yl[1]=e,yl}function Gr(i,t,e,n=!0){return s=>{s.button==0&&(!n||s.target==t)&&e(s)}}function Ml(i,t,e,n=!0){return s=>{(!n||s.target==t)&&e(s)}}const U0={show:!0,x:!0,y:!0,lock:!1,move:I0,points:{one:!1,show:P0,size:D0,width:0,stroke:N0,fill:L0},bind:{mousedown:Gr,mouseup:Gr,click:Gr,dblclick:Gr,mousemove:Ml,mouseleave:Ml,mouseenter:Ml},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,t,e,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Mp={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Ah=Xe({},Mp,{filter:lp}),Sp=Xe({},Ah,{size:10}),wp=Xe({},Mp,{show:!1}),Rh='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Ep="bold "+Rh,Tp=1.5,Zu={show:!0,scale:"x",stroke:vh,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Ep,side:2,grid:Ah,ticks:Sp,border:wp,font:Rh,lineGap:Tp,rotate:0},k0="Value",F0="Time",Ju={show:!0,scale:"x",auto:!1,sorted:1,min:Pe,max:-Pe,idxs:[]};function O0(i,t,e,n,s){return t.map(o=>o==null?"":Sh(o))}function B0(i,t,e,n,s,o,a){let r=[],l=us.get(s)||0;e=a?e:Le($a(e,s),l);for(let c=e;c<=n;c=Le(c+s,l))r.push(Object.is(c,-0)?0:c);return r}function mc(i,t,e,n,s,o,a){const r=[],l=i.scales[i.axes[t].scale].log,c=l==10?zi:op,h=zn(c(e));s=Uo(l,h),l==10&&(s=Ns[oi(s,Ns)]);let u=e,d=s*l;l==10&&(d=Ns[oi(d,Ns)]);do r.push(u),u=u+s,l==10&&!us.has(u)&&(u=Le(u,us.get(s))),u>=d&&(s=u,d=s*l,l==10&&(d=Ns[oi(d,Ns)]));while(u<=n);return r}function z0(i,t,e,n,s,o,a){let l=i.scales[i.axes[t].scale].asinh,c=n>l?mc(i,t,wn(l,e),n,s):[l],h=n>=0&&e<=0?[0]:[];return(e<-l?mc(i,t,wn(l,-n),-e,s):[l]).reverse().map(d=>-d).concat(h,c)}const Ap=/./,H0=/[12357]/,V0=/[125]/,Qu=/1/,gc=(i,t,e,n)=>i.map((s,o)=>t==4&&s==0||o%n==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function G0(i,t,e,n,s){let o=i.axes[e],a=o.scale,r=i.scales[a],l=i.valToPos,c=o._space,h=l(10,a),u=l(9,a)-h>=c?Ap:l(7,a)-h>=c?H0:l(5,a)-h>=c?V0:Qu;if(u==Qu){let d=Je(l(1,a)-h);if(d<c)return gc(t.slice().reverse(),r.distr,u,jn(c/d)).reverse()}return gc(t,r.distr,u,1)}function W0(i,t,e,n,s){let o=i.axes[e],a=o.scale,r=o._space,l=i.valToPos,c=Je(l(1,a)-l(2,a));return c<r?gc(t.slice().reverse(),3,Ap,jn(r/c)).reverse():t}function $0(i,t,e,n){return n==null?xh:t==null?"":Sh(t)}const td={show:!0,scale:"y",stroke:vh,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Ep,side:3,grid:Ah,ticks:Sp,border:wp,font:Rh,lineGap:Tp,rotate:0};function q0(i,t){let e=3+(i||1)*2;return Le(e*t,3)}function X0(i,t){let{scale:e,idxs:n}=i.series[0],s=i._data[0],o=i.valToPos(s[n[0]],e,!0),a=i.valToPos(s[n[1]],e,!0),r=Je(a-o),l=i.series[t],c=r/(l.points.space*Se);return n[1]-n[0]<=c}const ed={scale:null,auto:!0,sorted:0,min:Pe,max:-Pe},Rp=(i,t,e,n,s)=>s,nd={show:!0,auto:!0,sorted:0,gaps:Rp,alpha:1,facets:[Xe({},ed,{scale:"x"}),Xe({},ed,{scale:"y"})]},id={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Rp,alpha:1,points:{show:X0,filter:null},values:null,min:Pe,max:-Pe,idxs:[],path:null,clip:null};function j0(i,t,e,n,s){return e/10}const Cp={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Y0=Xe({},Cp,{time:!1,ori:1}),sd={};function Pp(i,t){let e=sd[i];return e||(e={key:i,plots:[],sub(n){e.plots.push(n)},unsub(n){e.plots=e.plots.filter(s=>s!=n)},pub(n,s,o,a,r,l,c){for(let h=0;h<e.plots.length;h++)e.plots[h]!=s&&e.plots[h].pub(n,s,o,a,r,l,c)}},i!=null&&(sd[i]=e)),e}const Oo=1,_c=2;function Ks(i,t,e){const n=i.mode,s=i.series[t],o=n==2?i._data[t]:i._data,a=i.scales,r=i.bbox;let l=o[0],c=n==2?o[1]:o[t],h=n==2?a[s.facets[0].scale]:a[i.series[0].scale],u=n==2?a[s.facets[1].scale]:a[s.scale],d=r.left,p=r.top,_=r.width,g=r.height,m=i.valToPosH,f=i.valToPosV;return h.ori==0?e(s,l,c,h,u,m,f,d,p,_,g,ja,Yo,Ka,Np,Ip):e(s,l,c,h,u,f,m,p,d,g,_,Ya,Ko,Lh,Dp,Up)}function Ch(i,t){let e=0,n=0,s=be(i.bands,wh);for(let o=0;o<s.length;o++){let a=s[o];a.series[0]==t?e=a.dir:a.series[1]==t&&(a.dir==1?n|=1:n|=2)}return[e,n==1?-1:n==2?1:n==3?2:0]}function K0(i,t,e,n,s){let o=i.mode,a=i.series[t],r=o==2?a.facets[1].scale:a.scale,l=i.scales[r];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Hi(i,t,e,n,s,o){return Ks(i,t,(a,r,l,c,h,u,d,p,_,g,m)=>{let f=a.pxRound;const M=c.dir*(c.ori==0?1:-1),S=c.ori==0?Yo:Ko;let x,F;M==1?(x=e,F=n):(x=n,F=e);let L=f(u(r[x],c,g,p)),A=f(d(l[x],h,m,_)),D=f(u(r[F],c,g,p)),E=f(d(o==1?h.max:h.min,h,m,_)),b=new Path2D(s);return S(b,D,E),S(b,L,E),S(b,L,A),b})}function Xa(i,t,e,n,s,o){let a=null;if(i.length>0){a=new Path2D;const r=t==0?Ka:Lh;let l=e;for(let u=0;u<i.length;u++){let d=i[u];if(d[1]>d[0]){let p=d[0]-l;p>0&&r(a,l,n,p,n+o),l=d[1]}}let c=e+s-l,h=10;c>0&&r(a,l,n-h/2,c,n+o+h)}return a}function Z0(i,t,e){let n=i[i.length-1];n&&n[0]==t?n[1]=e:i.push([t,e])}function Ph(i,t,e,n,s,o,a){let r=[],l=i.length;for(let c=s==1?e:n;c>=e&&c<=n;c+=s)if(t[c]===null){let u=c,d=c;if(s==1)for(;++c<=n&&t[c]===null;)d=c;else for(;--c>=e&&t[c]===null;)d=c;let p=o(i[u]),_=d==u?p:o(i[d]),g=u-s;p=a<=0&&g>=0&&g<l?o(i[g]):p;let f=d+s;_=a>=0&&f>=0&&f<l?o(i[f]):_,_>=p&&r.push([p,_])}return r}function od(i){return i==0?ap:i==1?Ke:t=>Ls(t,i)}function Lp(i){let t=i==0?ja:Ya,e=i==0?(s,o,a,r,l,c)=>{s.arcTo(o,a,r,l,c)}:(s,o,a,r,l,c)=>{s.arcTo(a,o,l,r,c)},n=i==0?(s,o,a,r,l)=>{s.rect(o,a,r,l)}:(s,o,a,r,l)=>{s.rect(a,o,l,r)};return(s,o,a,r,l,c=0,h=0)=>{c==0&&h==0?n(s,o,a,r,l):(c=ri(c,r/2,l/2),h=ri(h,r/2,l/2),t(s,o+c,a),e(s,o+r,a,o+r,a+l,c),e(s,o+r,a+l,o,a+l,h),e(s,o,a+l,o,a,h),e(s,o,a,o+r,a,c),s.closePath())}}const ja=(i,t,e)=>{i.moveTo(t,e)},Ya=(i,t,e)=>{i.moveTo(e,t)},Yo=(i,t,e)=>{i.lineTo(t,e)},Ko=(i,t,e)=>{i.lineTo(e,t)},Ka=Lp(0),Lh=Lp(1),Np=(i,t,e,n,s,o)=>{i.arc(t,e,n,s,o)},Dp=(i,t,e,n,s,o)=>{i.arc(e,t,n,s,o)},Ip=(i,t,e,n,s,o,a)=>{i.bezierCurveTo(t,e,n,s,o,a)},Up=(i,t,e,n,s,o,a)=>{i.bezierCurveTo(e,t,s,n,a,o)};function kp(i){return(t,e,n,s,o)=>Ks(t,e,(a,r,l,c,h,u,d,p,_,g,m)=>{let{pxRound:f,points:M}=a,S,x;c.ori==0?(S=ja,x=Np):(S=Ya,x=Dp);const F=Le(M.width*Se,3);let L=(M.size-M.width)/2*Se,A=Le(L*2,3),D=new Path2D,E=new Path2D,{left:b,top:R,width:H,height:O}=t.bbox;Ka(E,b-A,R-A,H+A*2,O+A*2);const q=$=>{if(l[$]!=null){let X=f(u(r[$],c,g,p)),j=f(d(l[$],h,m,_));S(D,X+L,j),x(D,X,j,L,0,_a*2)}};if(o)o.forEach(q);else for(let $=n;$<=s;$++)q($);return{stroke:F>0?D:null,fill:D,clip:E,flags:Oo|_c}})}function Fp(i){return(t,e,n,s,o,a)=>{n!=s&&(o!=n&&a!=n&&i(t,e,n),o!=s&&a!=s&&i(t,e,s),i(t,e,a))}}const J0=Fp(Yo),Q0=Fp(Ko);function Op(i){const t=be(i?.alignGaps,0);return(e,n,s,o)=>Ks(e,n,(a,r,l,c,h,u,d,p,_,g,m)=>{[s,o]=Ga(l,s,o);let f=a.pxRound,M=O=>f(u(O,c,g,p)),S=O=>f(d(O,h,m,_)),x,F;c.ori==0?(x=Yo,F=J0):(x=Ko,F=Q0);const L=c.dir*(c.ori==0?1:-1),A={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Oo},D=A.stroke;let E=!1;if(o-s>=g*4){let O=mt=>e.posToVal(mt,c.key,!0),q=null,$=null,X,j,Q,at=M(r[L==1?s:o]),lt=M(r[s]),gt=M(r[o]),xt=O(L==1?lt+1:gt-1);for(let mt=L==1?s:o;mt>=s&&mt<=o;mt+=L){let ot=r[mt],_t=(L==1?ot<xt:ot>xt)?at:M(ot),ht=l[mt];_t==at?ht!=null?(j=ht,q==null?(x(D,_t,S(j)),X=q=$=j):j<q?q=j:j>$&&($=j)):ht===null&&(E=!0):(q!=null&&F(D,at,S(q),S($),S(X),S(j)),ht!=null?(j=ht,x(D,_t,S(j)),q=$=X=j):(q=$=null,ht===null&&(E=!0)),at=_t,xt=O(at+L))}q!=null&&q!=$&&Q!=at&&F(D,at,S(q),S($),S(X),S(j))}else for(let O=L==1?s:o;O>=s&&O<=o;O+=L){let q=l[O];q===null?E=!0:q!=null&&x(D,M(r[O]),S(q))}let[R,H]=Ch(e,n);if(a.fill!=null||R!=0){let O=A.fill=new Path2D(D),q=a.fillTo(e,n,a.min,a.max,R),$=S(q),X=M(r[s]),j=M(r[o]);L==-1&&([j,X]=[X,j]),x(O,j,$),x(O,X,$)}if(!a.spanGaps){let O=[];E&&O.push(...Ph(r,l,s,o,L,M,t)),A.gaps=O=a.gaps(e,n,s,o,O),A.clip=Xa(O,c.ori,p,_,g,m)}return H!=0&&(A.band=H==2?[Hi(e,n,s,o,D,-1),Hi(e,n,s,o,D,1)]:Hi(e,n,s,o,D,H)),A})}function t_(i){const t=be(i.align,1),e=be(i.ascDesc,!1),n=be(i.alignGaps,0),s=be(i.extend,!1);return(o,a,r,l)=>Ks(o,a,(c,h,u,d,p,_,g,m,f,M,S)=>{[r,l]=Ga(u,r,l);let x=c.pxRound,{left:F,width:L}=o.bbox,A=lt=>x(_(lt,d,M,m)),D=lt=>x(g(lt,p,S,f)),E=d.ori==0?Yo:Ko;const b={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Oo},R=b.stroke,H=d.dir*(d.ori==0?1:-1);let O=D(u[H==1?r:l]),q=A(h[H==1?r:l]),$=q,X=q;s&&t==-1&&(X=F,E(R,X,O)),E(R,q,O);for(let lt=H==1?r:l;lt>=r&&lt<=l;lt+=H){let gt=u[lt];if(gt==null)continue;let xt=A(h[lt]),mt=D(gt);t==1?E(R,xt,O):E(R,$,mt),E(R,xt,mt),O=mt,$=xt}let j=$;s&&t==1&&(j=F+L,E(R,j,O));let[Q,at]=Ch(o,a);if(c.fill!=null||Q!=0){let lt=b.fill=new Path2D(R),gt=c.fillTo(o,a,c.min,c.max,Q),xt=D(gt);E(lt,j,xt),E(lt,X,xt)}if(!c.spanGaps){let lt=[];lt.push(...Ph(h,u,r,l,H,A,n));let gt=c.width*Se/2,xt=e||t==1?gt:-gt,mt=e||t==-1?-gt:gt;lt.forEach(ot=>{ot[0]+=xt,ot[1]+=mt}),b.gaps=lt=c.gaps(o,a,r,l,lt),b.clip=Xa(lt,d.ori,m,f,M,S)}return at!=0&&(b.band=at==2?[Hi(o,a,r,l,R,-1),Hi(o,a,r,l,R,1)]:Hi(o,a,r,l,R,at)),b})}function rd(i,t,e,n,s,o,a=Pe){if(i.length>1){let r=null;for(let l=0,c=1/0;l<i.length;l++)if(t[l]!==void 0){if(r!=null){let h=Je(i[l]-i[r]);h<c&&(c=h,a=Je(e(i[l],n,s,o)-e(i[r],n,s,o)))}r=l}}return a}function e_(i){i=i||Mr;const t=be(i.size,[.6,Pe,1]),e=i.align||0,n=i.gap||0;let s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;const o=le(s),a=1-t[0],r=be(t[1],Pe),l=be(t[2],1),c=be(i.disp,Mr),h=be(i.each,p=>{}),{fill:u,stroke:d}=c;return(p,_,g,m)=>Ks(p,_,(f,M,S,x,F,L,A,D,E,b,R)=>{let H=f.pxRound,O=e,q=n*Se,$=r*Se,X=l*Se,j,Q;x.ori==0?[j,Q]=o(p,_):[Q,j]=o(p,_);const at=x.dir*(x.ori==0?1:-1);let lt=x.ori==0?Ka:Lh,gt=x.ori==0?h:(Y,it,St,bt,At,Zt,pt)=>{h(Y,it,St,At,bt,pt,Zt)},xt=be(p.bands,wh).find(Y=>Y.series[0]==_),mt=xt!=null?xt.dir:0,ot=f.fillTo(p,_,f.min,f.max,mt),ut=H(A(ot,F,R,E)),_t,ht,It,zt=b,Ut=H(f.width*Se),ce=!1,Jt=null,he=null,G=null,je=null;u!=null&&(Ut==0||d!=null)&&(ce=!0,Jt=u.values(p,_,g,m),he=new Map,new Set(Jt).forEach(Y=>{Y!=null&&he.set(Y,new Path2D)}),Ut>0&&(G=d.values(p,_,g,m),je=new Map,new Set(G).forEach(Y=>{Y!=null&&je.set(Y,new Path2D)})));let{x0:ee,size:ie}=c;if(ee!=null&&ie!=null){O=1,M=ee.values(p,_,g,m),ee.unit==2&&(M=M.map(St=>p.posToVal(D+St*b,x.key,!0)));let Y=ie.values(p,_,g,m);ie.unit==2?ht=Y[0]*b:ht=L(Y[0],x,b,D)-L(0,x,b,D),zt=rd(M,S,L,x,b,D,zt),It=zt-ht+q}else zt=rd(M,S,L,x,b,D,zt),It=zt*a+q,ht=zt-It;It<1&&(It=0),Ut>=ht/2&&(Ut=0),It<5&&(H=ap);let Wt=It>0,fe=zt-It-(Wt?Ut:0);ht=H(pc(fe,X,$)),_t=(O==0?ht/2:O==at?0:ht)-O*at*((O==0?q/2:0)+(Wt?Ut/2:0));const Nt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},N=ce?null:new Path2D;let w=null;if(xt!=null)w=p.data[xt.series[1]];else{let{y0:Y,y1:it}=c;Y!=null&&it!=null&&(S=it.values(p,_,g,m),w=Y.values(p,_,g,m))}let tt=j*ht,nt=Q*ht;for(let Y=at==1?g:m;Y>=g&&Y<=m;Y+=at){let it=S[Y];if(it==null)continue;if(w!=null){let Ht=w[Y]??0;if(it-Ht==0)continue;ut=A(Ht,F,R,E)}let St=x.distr!=2||c!=null?M[Y]:Y,bt=L(St,x,b,D),At=A(be(it,ot),F,R,E),Zt=H(bt-_t),pt=H(wn(At,ut)),yt=H(ri(At,ut)),Ot=pt-yt;if(it!=null){let Ht=it<0?nt:tt,Et=it<0?tt:nt;ce?(Ut>0&&G[Y]!=null&&lt(je.get(G[Y]),Zt,yt+zn(Ut/2),ht,wn(0,Ot-Ut),Ht,Et),Jt[Y]!=null&&lt(he.get(Jt[Y]),Zt,yt+zn(Ut/2),ht,wn(0,Ot-Ut),Ht,Et)):lt(N,Zt,yt+zn(Ut/2),ht,wn(0,Ot-Ut),Ht,Et),gt(p,_,Y,Zt-Ut/2,yt,ht+Ut,Ot)}}return Ut>0?Nt.stroke=ce?je:N:ce||(Nt._fill=f.width==0?f._fill:f._stroke??f._fill,Nt.width=0),Nt.fill=ce?he:N,Nt})}function n_(i,t){const e=be(t?.alignGaps,0);return(n,s,o,a)=>Ks(n,s,(r,l,c,h,u,d,p,_,g,m,f)=>{[o,a]=Ga(c,o,a);let M=r.pxRound,S=j=>M(d(j,h,m,_)),x=j=>M(p(j,u,f,g)),F,L,A;h.ori==0?(F=ja,A=Yo,L=Ip):(F=Ya,A=Ko,L=Up);const D=h.dir*(h.ori==0?1:-1);let E=S(l[D==1?o:a]),b=E,R=[],H=[];for(let j=D==1?o:a;j>=o&&j<=a;j+=D)if(c[j]!=null){let at=l[j],lt=S(at);R.push(b=lt),H.push(x(c[j]))}const O={stroke:i(R,H,F,A,L,M),fill:null,clip:null,band:null,gaps:null,flags:Oo},q=O.stroke;let[$,X]=Ch(n,s);if(r.fill!=null||$!=0){let j=O.fill=new Path2D(q),Q=r.fillTo(n,s,r.min,r.max,$),at=x(Q);A(j,b,at),A(j,E,at)}if(!r.spanGaps){let j=[];j.push(...Ph(l,c,o,a,D,S,e)),O.gaps=j=r.gaps(n,s,o,a,j),O.clip=Xa(j,h.ori,_,g,m,f)}return X!=0&&(O.band=X==2?[Hi(n,s,o,a,q,-1),Hi(n,s,o,a,q,1)]:Hi(n,s,o,a,q,X)),O})}function i_(i){return n_(s_,i)}function s_(i,t,e,n,s,o){const a=i.length;if(a<2)return null;const r=new Path2D;if(e(r,i[0],t[0]),a==2)n(r,i[1],t[1]);else{let l=Array(a),c=Array(a-1),h=Array(a-1),u=Array(a-1);for(let d=0;d<a-1;d++)h[d]=t[d+1]-t[d],u[d]=i[d+1]-i[d],c[d]=h[d]/u[d];l[0]=c[0];for(let d=1;d<a-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(u[d-1]+u[d])/((2*u[d]+u[d-1])/c[d-1]+(u[d]+2*u[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[a-1]=c[a-2];for(let d=0;d<a-1;d++)s(r,i[d]+u[d]/3,t[d]+l[d]*u[d]/3,i[d+1]-u[d]/3,t[d+1]-l[d+1]*u[d]/3,i[d+1],t[d+1])}return r}const vc=new Set;function ad(){for(let i of vc)i.syncRect(!0)}jo&&(zs(Og,Lo,ad),zs(Bg,Lo,ad,!0),zs(Ra,Lo,()=>{vn.pxRatio=Se}));const o_=Op(),r_=kp();function ld(i,t,e,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((o,a)=>xc(o,a,t,e))}function a_(i,t){return i.map((e,n)=>n==0?{}:Xe({},t,e))}function xc(i,t,e,n){return Xe({},t==0?e:n,i)}function Bp(i,t,e){return t==null?ko:[t,e]}const l_=Bp;function c_(i,t,e){return t==null?ko:Ca(t,e,Mh,!0)}function zp(i,t,e,n){return t==null?ko:Wa(t,e,i.scales[n].log,!1)}const h_=zp;function Hp(i,t,e,n){return t==null?ko:yh(t,e,i.scales[n].log,!1)}const u_=Hp;function d_(i,t,e,n,s){let o=wn(zu(i),zu(t)),a=t-i,r=oi(s/n*a,e);do{let l=e[r],c=n*l/a;if(c>=s&&o+(l<5?us.get(l):0)<=17)return[l,c]}while(++r<e.length);return[0,0]}function cd(i){let t,e;return i=i.replace(/(\d+)px/,(n,s)=>(t=Ke((e=+s)*Se))+"px"),[i,t,e]}function f_(i){i.show&&[i.font,i.labelFont].forEach(t=>{let e=Le(t[2]*Se,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function vn(i,t,e){const n={mode:be(i.mode,1)},s=n.mode;function o(v,y,P,I){let B=y.valToPct(v);return I+P*(y.dir==-1?1-B:B)}function a(v,y,P,I){let B=y.valToPct(v);return I+P*(y.dir==-1?B:1-B)}function r(v,y,P,I){return y.ori==0?o(v,y,P,I):a(v,y,P,I)}n.valToPosH=o,n.valToPosV=a;let l=!1;n.status=0;const c=n.root=Xn(bg);if(i.id!=null&&(c.id=i.id),Fn(c,i.class),i.title){let v=Xn(Sg,c);v.textContent=i.title}const h=ii("canvas"),u=n.ctx=h.getContext("2d"),d=Xn(wg,c);zs("click",d,v=>{v.target===_&&(De!=so||Be!=oo)&&un.click(n,v)},!0);const p=n.under=Xn(Eg,d);d.appendChild(h);const _=n.over=Xn(Tg,d);i=Fo(i);const g=+be(i.pxAlign,1),m=od(g);(i.plugins||[]).forEach(v=>{v.opts&&(i=v.opts(n,i)||i)});const f=i.ms||.001,M=n.series=s==1?ld(i.series||[],Ju,id,!1):a_(i.series||[null],nd),S=n.axes=ld(i.axes||[],Zu,td,!0),x=n.scales={},F=n.bands=i.bands||[];F.forEach(v=>{v.fill=le(v.fill||null),v.dir=be(v.dir,-1)});const L=s==2?M[1].facets[0].scale:M[0].scale,A={axes:og,series:Vn},D=(i.drawOrder||["axes","series"]).map(v=>A[v]);function E(v){const y=v.distr==3?P=>zi(P>0?P:v.clamp(n,P,v.min,v.max,v.key)):v.distr==4?P=>xl(P,v.asinh):v.distr==100?P=>v.fwd(P):P=>P;return P=>{let I=y(P),{_min:B,_max:J}=v,rt=J-B;return(I-B)/rt}}function b(v){let y=x[v];if(y==null){let P=(i.scales||Mr)[v]||Mr;if(P.from!=null){b(P.from);let I=Xe({},x[P.from],P,{key:v});I.valToPct=E(I),x[v]=I}else{y=x[v]=Xe({},v==L?Cp:Y0,P),y.key=v;let I=y.time,B=y.range,J=ss(B);if((v!=L||s==2&&!I)&&(J&&(B[0]==null||B[1]==null)&&(B={min:B[0]==null?Fu:{mode:1,hard:B[0],soft:B[0]},max:B[1]==null?Fu:{mode:1,hard:B[1],soft:B[1]}},J=!1),!J&&qa(B))){let rt=B;B=(dt,vt,Pt)=>vt==null?ko:Ca(vt,Pt,rt)}y.range=le(B||(I?l_:v==L?y.distr==3?h_:y.distr==4?u_:Bp:y.distr==3?zp:y.distr==4?Hp:c_)),y.auto=le(J?!1:y.auto),y.clamp=le(y.clamp||j0),y._min=y._max=null,y.valToPct=E(y)}}}b("x"),b("y"),s==1&&M.forEach(v=>{b(v.scale)}),S.forEach(v=>{b(v.scale)});for(let v in i.scales)b(v);const R=x[L],H=R.distr;let O,q;R.ori==0?(Fn(c,yg),O=o,q=a):(Fn(c,Mg),O=a,q=o);const $={};for(let v in x){let y=x[v];(y.min!=null||y.max!=null)&&($[v]={min:y.min,max:y.max},y.min=y.max=null)}const X=i.tzDate||(v=>new Date(Ke(v/f))),j=i.fmtDate||Eh,Q=f==1?y0(X):w0(X),at=ju(X,Xu(f==1?b0:S0,j)),lt=Ku(X,Yu(T0,j)),gt=[],xt=n.legend=Xe({},C0,i.legend),mt=n.cursor=Xe({},U0,{drag:{y:s==2}},i.cursor),ot=xt.show,ut=mt.show,_t=xt.markers;xt.idxs=gt,_t.width=le(_t.width),_t.dash=le(_t.dash),_t.stroke=le(_t.stroke),_t.fill=le(_t.fill);let ht,It,zt,Ut=[],ce=[],Jt,he=!1,G={};if(xt.live){const v=M[1]?M[1].values:null;he=v!=null,Jt=he?v(n,1,0):{_:0};for(let y in Jt)G[y]=xh}if(ot)if(ht=ii("table",Ng,c),zt=ii("tbody",null,ht),xt.mount(n,ht),he){It=ii("thead",null,ht,zt);let v=ii("tr",null,It);ii("th",null,v);for(var je in Jt)ii("th",wu,v).textContent=je}else Fn(ht,Ig),xt.live&&Fn(ht,Dg);const ee={show:!0},ie={show:!1};function Wt(v,y){if(y==0&&(he||!xt.live||s==2))return ko;let P=[],I=ii("tr",Ug,zt,zt.childNodes[y]);Fn(I,v.class),v.show||Fn(I,Is);let B=ii("th",null,I);if(_t.show){let dt=Xn(kg,B);if(y>0){let vt=_t.width(n,y);vt&&(dt.style.border=vt+"px "+_t.dash(n,y)+" "+_t.stroke(n,y)),dt.style.background=_t.fill(n,y)}}let J=Xn(wu,B);v.label instanceof HTMLElement?J.appendChild(v.label):J.textContent=v.label,y>0&&(_t.show||(J.style.color=v.width>0?_t.stroke(n,y):_t.fill(n,y)),Nt("click",B,dt=>{if(mt._lock)return;Ye(dt);let vt=M.indexOf(v);if((dt.ctrlKey||dt.metaKey)!=xt.isolate){let Pt=M.some((Lt,Dt)=>Dt>0&&Dt!=vt&&Lt.show);M.forEach((Lt,Dt)=>{Dt>0&&fi(Dt,Pt?Dt==vt?ee:ie:ee,!0,$e.setSeries)})}else fi(vt,{show:!v.show},!0,$e.setSeries)},!1),Ti&&Nt(Ru,B,dt=>{mt._lock||(Ye(dt),fi(M.indexOf(v),ao,!0,$e.setSeries))},!1));for(var rt in Jt){let dt=ii("td",Fg,I);dt.textContent="--",P.push(dt)}return[I,P]}const fe=new Map;function Nt(v,y,P,I=!0){const B=fe.get(y)||{},J=mt.bind[v](n,y,P,I);J&&(zs(v,y,B[v]=J),fe.set(y,B))}function N(v,y,P){const I=fe.get(y)||{};for(let B in I)(v==null||B==v)&&(fc(B,y,I[B]),delete I[B]);v==null&&fe.delete(y)}let w=0,tt=0,nt=0,Y=0,it=0,St=0,bt=it,At=St,Zt=nt,pt=Y,yt=0,Ot=0,Ht=0,Et=0;n.bbox={};let oe=!1,Yt=!1,pe=!1,V=!1,Mt=!1,st=!1;function ct(v,y,P){(P||v!=n.width||y!=n.height)&&Rt(v,y),to(!1),pe=!0,Yt=!0,eo()}function Rt(v,y){n.width=w=nt=v,n.height=tt=Y=y,it=St=0,nn(),ye();let P=n.bbox;yt=P.left=Ls(it*Se,.5),Ot=P.top=Ls(St*Se,.5),Ht=P.width=Ls(nt*Se,.5),Et=P.height=Ls(Y*Se,.5)}const Ct=3;function Qt(){let v=!1,y=0;for(;!v;){y++;let P=ig(y),I=sg(y);v=y==Ct||P&&I,v||(Rt(n.width,n.height),Yt=!0)}}function Fe({width:v,height:y}){ct(v,y)}n.setSize=Fe;function nn(){let v=!1,y=!1,P=!1,I=!1;S.forEach((B,J)=>{if(B.show&&B._show){let{side:rt,_size:dt}=B,vt=rt%2,Pt=B.label!=null?B.labelSize:0,Lt=dt+Pt;Lt>0&&(vt?(nt-=Lt,rt==3?(it+=Lt,I=!0):P=!0):(Y-=Lt,rt==0?(St+=Lt,v=!0):y=!0))}}),hi[0]=v,hi[1]=P,hi[2]=y,hi[3]=I,nt-=T[1]+T[3],it+=T[3],Y-=T[2]+T[0],St+=T[0]}function ye(){let v=it+nt,y=St+Y,P=it,I=St;function B(J,rt){switch(J){case 1:return v+=rt,v-rt;case 2:return y+=rt,y-rt;case 3:return P-=rt,P+rt;case 0:return I-=rt,I+rt}}S.forEach((J,rt)=>{if(J.show&&J._show){let dt=J.side;J._pos=B(dt,J._size),J.label!=null&&(J._lpos=B(dt,J.labelSize))}})}if(mt.dataIdx==null){let v=mt.hover,y=v.skip=new Set(v.skip??[]);y.add(void 0);let P=v.prox=le(v.prox),I=v.bias??=0;mt.dataIdx=(B,J,rt,dt)=>{if(J==0)return rt;let vt=rt,Pt=P(B,J,rt,dt)??Pe,Lt=Pt>=0&&Pt<Pe,Dt=R.ori==0?nt:Y,Kt=mt.left,Me=t[0],xe=t[J];if(y.has(xe[rt])){vt=null;let re=null,qt=null,Gt;if(I==0||I==-1)for(Gt=rt;re==null&&Gt-- >0;)y.has(xe[Gt])||(re=Gt);if(I==0||I==1)for(Gt=rt;qt==null&&Gt++<xe.length;)y.has(xe[Gt])||(qt=Gt);if(re!=null||qt!=null)if(Lt){let Ue=re==null?-1/0:O(Me[re],R,Dt,0),Ve=qt==null?1/0:O(Me[qt],R,Dt,0),ln=Kt-Ue,Ae=Ve-Kt;ln<=Ae?ln<=Pt&&(vt=re):Ae<=Pt&&(vt=qt)}else vt=qt==null?re:re==null?qt:rt-re<=qt-rt?re:qt}else Lt&&Je(Kt-O(Me[rt],R,Dt,0))>Pt&&(vt=null);return vt}}const Ye=v=>{mt.event=v};mt.idxs=gt,mt._lock=!1;let Ne=mt.points;Ne.show=le(Ne.show),Ne.size=le(Ne.size),Ne.stroke=le(Ne.stroke),Ne.width=le(Ne.width),Ne.fill=le(Ne.fill);const Ln=n.focus=Xe({},i.focus||{alpha:.3},mt.focus),Ti=Ln.prox>=0,Tn=Ti&&Ne.one;let pn=[],Ai=[],Ri=[];function vs(v,y){let P=Ne.show(n,y);if(P instanceof HTMLElement)return Fn(P,Lg),Fn(P,v.class),_i(P,-10,-10,nt,Y),_.insertBefore(P,pn[y]),P}function er(v,y){if(s==1||y>0){let P=s==1&&x[v.scale].time,I=v.value;v.value=P?Gu(I)?Ku(X,Yu(I,j)):I||lt:I||$0,v.label=v.label||(P?F0:k0)}if(Tn||y>0){v.width=v.width==null?1:v.width,v.paths=v.paths||o_||Yg,v.fillTo=le(v.fillTo||K0),v.pxAlign=+be(v.pxAlign,g),v.pxRound=od(v.pxAlign),v.stroke=le(v.stroke||null),v.fill=le(v.fill||null),v._stroke=v._fill=v._paths=v._focus=null;let P=q0(wn(1,v.width),1),I=v.points=Xe({},{size:P,width:wn(1,P*.2),stroke:v.stroke,space:P*2,paths:r_,_stroke:null,_fill:null},v.points);I.show=le(I.show),I.filter=le(I.filter),I.fill=le(I.fill),I.stroke=le(I.stroke),I.paths=le(I.paths),I.pxAlign=v.pxAlign}if(ot){let P=Wt(v,y);Ut.splice(y,0,P[0]),ce.splice(y,0,P[1]),xt.values.push(null)}if(ut){gt.splice(y,0,null);let P=null;Tn?y==0&&(P=vs(v,y)):y>0&&(P=vs(v,y)),pn.splice(y,0,P),Ai.splice(y,0,0),Ri.splice(y,0,0)}an("addSeries",y)}function Js(v,y){y=y??M.length,v=s==1?xc(v,y,Ju,id):xc(v,y,{},nd),M.splice(y,0,v),er(M[y],y)}n.addSeries=Js;function Ir(v){if(M.splice(v,1),ot){xt.values.splice(v,1),ce.splice(v,1);let y=Ut.splice(v,1)[0];N(null,y.firstChild),y.remove()}ut&&(gt.splice(v,1),pn.splice(v,1)[0].remove(),Ai.splice(v,1),Ri.splice(v,1)),an("delSeries",v)}n.delSeries=Ir;const hi=[!1,!1,!1,!1];function sl(v,y){if(v._show=v.show,v.show){let P=v.side%2,I=x[v.scale];I==null&&(v.scale=P?M[1].scale:L,I=x[v.scale]);let B=I.time;v.size=le(v.size),v.space=le(v.space),v.rotate=le(v.rotate),ss(v.incrs)&&v.incrs.forEach(rt=>{!us.has(rt)&&us.set(rt,hp(rt))}),v.incrs=le(v.incrs||(I.distr==2?_0:B?f==1?x0:M0:Ns)),v.splits=le(v.splits||(B&&I.distr==1?Q:I.distr==3?mc:I.distr==4?z0:B0)),v.stroke=le(v.stroke),v.grid.stroke=le(v.grid.stroke),v.ticks.stroke=le(v.ticks.stroke),v.border.stroke=le(v.border.stroke);let J=v.values;v.values=ss(J)&&!ss(J[0])?le(J):B?ss(J)?ju(X,Xu(J,j)):Gu(J)?E0(X,J):J||at:J||O0,v.filter=le(v.filter||(I.distr>=3&&I.log==10?G0:I.distr==3&&I.log==2?W0:lp)),v.font=cd(v.font),v.labelFont=cd(v.labelFont),v._size=v.size(n,null,y,0),v._space=v._rotate=v._incrs=v._found=v._splits=v._values=null,v._size>0&&(hi[y]=!0,v._el=Xn(Ag,d))}}function xs(v,y,P,I){let[B,J,rt,dt]=P,vt=y%2,Pt=0;return vt==0&&(dt||J)&&(Pt=y==0&&!B||y==2&&!rt?Ke(Zu.size/3):0),vt==1&&(B||rt)&&(Pt=y==1&&!J||y==3&&!dt?Ke(td.size/2):0),Pt}const Ur=n.padding=(i.padding||[xs,xs,xs,xs]).map(v=>le(be(v,xs))),T=n._padding=Ur.map((v,y)=>v(n,y,hi,0));let z,K=null,Z=null;const W=s==1?M[0].idxs:null;let ft=null,wt=!1;function Bt(v,y){if(t=v??[],n.data=n._data=t,s==2){z=0;for(let P=1;P<M.length;P++)z+=t[P][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),ft=t[0],z=ft.length;let P=t;if(H==2){P=t.slice();let I=P[0]=Array(z);for(let B=0;B<z;B++)I[B]=B}n._data=t=P}if(to(!0),an("setData"),H==2&&(pe=!0),y!==!1){let P=R;P.auto(n,wt)?kt():ji(L,P.min,P.max),V=V||mt.left>=0,st=!0,eo()}}n.setData=Bt;function kt(){wt=!0;let v,y;s==1&&(z>0?(K=W[0]=0,Z=W[1]=z-1,v=t[0][K],y=t[0][Z],H==2?(v=K,y=Z):v==y&&(H==3?[v,y]=Wa(v,v,R.log,!1):H==4?[v,y]=yh(v,v,R.log,!1):R.time?y=v+Ke(86400/f):[v,y]=Ca(v,y,Mh,!0))):(K=W[0]=v=null,Z=W[1]=y=null)),ji(L,v,y)}let $t,jt,Ft,ae,we,Te,sn,ue,Vt,Oe;function me(v,y,P,I,B,J){v??=Tu,P??=wh,I??="butt",B??=Tu,J??="round",v!=$t&&(u.strokeStyle=$t=v),B!=jt&&(u.fillStyle=jt=B),y!=Ft&&(u.lineWidth=Ft=y),J!=we&&(u.lineJoin=we=J),I!=Te&&(u.lineCap=Te=I),P!=ae&&u.setLineDash(ae=P)}function An(v,y,P,I){y!=jt&&(u.fillStyle=jt=y),v!=sn&&(u.font=sn=v),P!=ue&&(u.textAlign=ue=P),I!=Vt&&(u.textBaseline=Vt=I)}function ui(v,y,P,I,B=0){if(I.length>0&&v.auto(n,wt)&&(y==null||y.min==null)){let J=be(K,0),rt=be(Z,I.length-1),dt=P.min==null?Gg(I,J,rt,B,v.distr==3):[P.min,P.max];v.min=ri(v.min,P.min=dt[0]),v.max=wn(v.max,P.max=dt[1])}}const mn={min:null,max:null};function bs(){for(let I in x){let B=x[I];$[I]==null&&(B.min==null||$[L]!=null&&B.auto(n,wt))&&($[I]=mn)}for(let I in x){let B=x[I];$[I]==null&&B.from!=null&&$[B.from]!=null&&($[I]=mn)}$[L]!=null&&to(!0);let v={};for(let I in $){let B=$[I];if(B!=null){let J=v[I]=Fo(x[I],Jg);if(B.min!=null)Xe(J,B);else if(I!=L||s==2)if(z==0&&J.from==null){let rt=J.range(n,null,null,I);J.min=rt[0],J.max=rt[1]}else J.min=Pe,J.max=-Pe}}if(z>0){M.forEach((I,B)=>{if(s==1){let J=I.scale,rt=$[J];if(rt==null)return;let dt=v[J];if(B==0){let vt=dt.range(n,dt.min,dt.max,J);dt.min=vt[0],dt.max=vt[1],K=oi(dt.min,t[0]),Z=oi(dt.max,t[0]),Z-K>1&&(t[0][K]<dt.min&&K++,t[0][Z]>dt.max&&Z--),I.min=ft[K],I.max=ft[Z]}else I.show&&I.auto&&ui(dt,rt,I,t[B],I.sorted);I.idxs[0]=K,I.idxs[1]=Z}else if(B>0&&I.show&&I.auto){let[J,rt]=I.facets,dt=J.scale,vt=rt.scale,[Pt,Lt]=t[B],Dt=v[dt],Kt=v[vt];Dt!=null&&ui(Dt,$[dt],J,Pt,J.sorted),Kt!=null&&ui(Kt,$[vt],rt,Lt,rt.sorted),I.min=rt.min,I.max=rt.max}});for(let I in v){let B=v[I],J=$[I];if(B.from==null&&(J==null||J.min==null)){let rt=B.range(n,B.min==Pe?null:B.min,B.max==-Pe?null:B.max,I);B.min=rt[0],B.max=rt[1]}}}for(let I in v){let B=v[I];if(B.from!=null){let J=v[B.from];if(J.min==null)B.min=B.max=null;else{let rt=B.range(n,J.min,J.max,I);B.min=rt[0],B.max=rt[1]}}}let y={},P=!1;for(let I in v){let B=v[I],J=x[I];if(J.min!=B.min||J.max!=B.max){J.min=B.min,J.max=B.max;let rt=J.distr;J._min=rt==3?zi(J.min):rt==4?xl(J.min,J.asinh):rt==100?J.fwd(J.min):J.min,J._max=rt==3?zi(J.max):rt==4?xl(J.max,J.asinh):rt==100?J.fwd(J.max):J.max,y[I]=P=!0}}if(P){M.forEach((I,B)=>{s==2?B>0&&y.y&&(I._paths=null):y[I.scale]&&(I._paths=null)});for(let I in y)pe=!0,an("setScale",I);ut&&mt.left>=0&&(V=st=!0)}for(let I in $)$[I]=null}function Ce(v){let y=pc(K-1,0,z-1),P=pc(Z+1,0,z-1);for(;v[y]==null&&y>0;)y--;for(;v[P]==null&&P<z-1;)P++;return[y,P]}function Vn(){if(z>0){let v=M.some(y=>y._focus)&&Oe!=Ln.alpha;v&&(u.globalAlpha=Oe=Ln.alpha),M.forEach((y,P)=>{if(P>0&&y.show&&(qi(P,!1),qi(P,!0),y._paths==null)){let I=Oe;Oe!=y.alpha&&(u.globalAlpha=Oe=y.alpha);let B=s==2?[0,t[P][0].length-1]:Ce(t[P]);y._paths=y.paths(n,P,B[0],B[1]),Oe!=I&&(u.globalAlpha=Oe=I)}}),M.forEach((y,P)=>{if(P>0&&y.show){let I=Oe;Oe!=y.alpha&&(u.globalAlpha=Oe=y.alpha),y._paths!=null&&xn(P,!1);{let B=y._paths!=null?y._paths.gaps:null,J=y.points.show(n,P,K,Z,B),rt=y.points.filter(n,P,J,B);(J||rt)&&(y.points._paths=y.points.paths(n,P,K,Z,rt),xn(P,!0))}Oe!=I&&(u.globalAlpha=Oe=I),an("drawSeries",P)}}),v&&(u.globalAlpha=Oe=1)}}function qi(v,y){let P=y?M[v].points:M[v];P._stroke=P.stroke(n,v),P._fill=P.fill(n,v)}function xn(v,y){let P=y?M[v].points:M[v],{stroke:I,fill:B,clip:J,flags:rt,_stroke:dt=P._stroke,_fill:vt=P._fill,_width:Pt=P.width}=P._paths;Pt=Le(Pt*Se,3);let Lt=null,Dt=Pt%2/2;y&&vt==null&&(vt=Pt>0?"#fff":dt);let Kt=P.pxAlign==1&&Dt>0;if(Kt&&u.translate(Dt,Dt),!y){let Me=yt-Pt/2,xe=Ot-Pt/2,re=Ht+Pt,qt=Et+Pt;Lt=new Path2D,Lt.rect(Me,xe,re,qt)}y?Qs(dt,Pt,P.dash,P.cap,vt,I,B,rt,J):di(v,dt,Pt,P.dash,P.cap,vt,I,B,rt,Lt,J),Kt&&u.translate(-Dt,-Dt)}function di(v,y,P,I,B,J,rt,dt,vt,Pt,Lt){let Dt=!1;vt!=0&&F.forEach((Kt,Me)=>{if(Kt.series[0]==v){let xe=M[Kt.series[1]],re=t[Kt.series[1]],qt=(xe._paths||Mr).band;ss(qt)&&(qt=Kt.dir==1?qt[0]:qt[1]);let Gt,Ue=null;xe.show&&qt&&$g(re,K,Z)?(Ue=Kt.fill(n,Me)||J,Gt=xe._paths.clip):qt=null,Qs(y,P,I,B,Ue,rt,dt,vt,Pt,Lt,Gt,qt),Dt=!0}}),Dt||Qs(y,P,I,B,J,rt,dt,vt,Pt,Lt)}const Zn=Oo|_c;function Qs(v,y,P,I,B,J,rt,dt,vt,Pt,Lt,Dt){me(v,y,P,I,B),(vt||Pt||Dt)&&(u.save(),vt&&u.clip(vt),Pt&&u.clip(Pt)),Dt?(dt&Zn)==Zn?(u.clip(Dt),Lt&&u.clip(Lt),Fr(B,rt),kr(v,J,y)):dt&_c?(Fr(B,rt),u.clip(Dt),kr(v,J,y)):dt&Oo&&(u.save(),u.clip(Dt),Lt&&u.clip(Lt),Fr(B,rt),u.restore(),kr(v,J,y)):(Fr(B,rt),kr(v,J,y)),(vt||Pt||Dt)&&u.restore()}function kr(v,y,P){P>0&&(y instanceof Map?y.forEach((I,B)=>{u.strokeStyle=$t=B,u.stroke(I)}):y!=null&&v&&u.stroke(y))}function Fr(v,y){y instanceof Map?y.forEach((P,I)=>{u.fillStyle=jt=I,u.fill(P)}):y!=null&&v&&u.fill(y)}function ng(v,y,P,I){let B=S[v],J;if(I<=0)J=[0,0];else{let rt=B._space=B.space(n,v,y,P,I),dt=B._incrs=B.incrs(n,v,y,P,I,rt);J=d_(y,P,dt,I,rt)}return B._found=J}function ol(v,y,P,I,B,J,rt,dt,vt,Pt){let Lt=rt%2/2;g==1&&u.translate(Lt,Lt),me(dt,rt,vt,Pt,dt),u.beginPath();let Dt,Kt,Me,xe,re=B+(I==0||I==3?-J:J);P==0?(Kt=B,xe=re):(Dt=B,Me=re);for(let qt=0;qt<v.length;qt++)y[qt]!=null&&(P==0?Dt=Me=v[qt]:Kt=xe=v[qt],u.moveTo(Dt,Kt),u.lineTo(Me,xe));u.stroke(),g==1&&u.translate(-Lt,-Lt)}function ig(v){let y=!0;return S.forEach((P,I)=>{if(!P.show)return;let B=x[P.scale];if(B.min==null){P._show&&(y=!1,P._show=!1,to(!1));return}else P._show||(y=!1,P._show=!0,to(!1));let J=P.side,rt=J%2,{min:dt,max:vt}=B,[Pt,Lt]=ng(I,dt,vt,rt==0?nt:Y);if(Lt==0)return;let Dt=B.distr==2,Kt=P._splits=P.splits(n,I,dt,vt,Pt,Lt,Dt),Me=B.distr==2?Kt.map(Gt=>ft[Gt]):Kt,xe=B.distr==2?ft[Kt[1]]-ft[Kt[0]]:Pt,re=P._values=P.values(n,P.filter(n,Me,I,Lt,xe),I,Lt,xe);P._rotate=J==2?P.rotate(n,re,I,Lt):0;let qt=P._size;P._size=jn(P.size(n,re,I,v)),qt!=null&&P._size!=qt&&(y=!1)}),y}function sg(v){let y=!0;return Ur.forEach((P,I)=>{let B=P(n,I,hi,v);B!=T[I]&&(y=!1),T[I]=B}),y}function og(){for(let v=0;v<S.length;v++){let y=S[v];if(!y.show||!y._show)continue;let P=y.side,I=P%2,B,J,rt=y.stroke(n,v),dt=P==0||P==3?-1:1,[vt,Pt]=y._found;if(y.label!=null){let yn=y.labelGap*dt,In=Ke((y._lpos+yn)*Se);An(y.labelFont[0],rt,"center",P==2?"top":Eu),u.save(),I==1?(B=J=0,u.translate(In,Ke(Ot+Et/2)),u.rotate((P==3?-_a:_a)/2)):(B=Ke(yt+Ht/2),J=In);let Ss=rp(y.label)?y.label(n,v,vt,Pt):y.label;u.fillText(Ss,B,J),u.restore()}if(Pt==0)continue;let Lt=x[y.scale],Dt=I==0?Ht:Et,Kt=I==0?yt:Ot,Me=y._splits,xe=Lt.distr==2?Me.map(yn=>ft[yn]):Me,re=Lt.distr==2?ft[Me[1]]-ft[Me[0]]:vt,qt=y.ticks,Gt=y.border,Ue=qt.show?qt.size:0,Ve=Ke(Ue*Se),ln=Ke((y.alignTo==2?y._size-Ue-y.gap:y.gap)*Se),Ae=y._rotate*-_a/180,Ge=m(y._pos*Se),Nn=(Ve+ln)*dt,bn=Ge+Nn;J=I==0?bn:0,B=I==1?bn:0;let Gn=y.font[0],Jn=y.align==1?co:y.align==2?gl:Ae>0?co:Ae<0?gl:I==0?"center":P==3?gl:co,mi=Ae||I==1?"middle":P==2?"top":Eu;An(Gn,rt,Jn,mi);let Dn=y.font[1]*y.lineGap,Wn=Me.map(yn=>m(r(yn,Lt,Dt,Kt))),Qn=y._values;for(let yn=0;yn<Qn.length;yn++){let In=Qn[yn];if(In!=null){I==0?B=Wn[yn]:J=Wn[yn],In=""+In;let Ss=In.indexOf(`
`)==-1?[In]:In.split(/\n/gm);for(let Mn=0;Mn<Ss.length;Mn++){let Su=Ss[Mn];Ae?(u.save(),u.translate(B,J+Mn*Dn),u.rotate(Ae),u.fillText(Su,0,0),u.restore()):u.fillText(Su,B,J+Mn*Dn)}}}qt.show&&ol(Wn,qt.filter(n,xe,v,Pt,re),I,P,Ge,Ve,Le(qt.width*Se,3),qt.stroke(n,v),qt.dash,qt.cap);let gi=y.grid;gi.show&&ol(Wn,gi.filter(n,xe,v,Pt,re),I,I==0?2:1,I==0?Ot:yt,I==0?Et:Ht,Le(gi.width*Se,3),gi.stroke(n,v),gi.dash,gi.cap),Gt.show&&ol([Ge],[1],I==0?1:0,I==0?1:2,I==1?Ot:yt,I==1?Et:Ht,Le(Gt.width*Se,3),Gt.stroke(n,v),Gt.dash,Gt.cap)}an("drawAxes")}function to(v){M.forEach((y,P)=>{P>0&&(y._paths=null,v&&(s==1?(y.min=null,y.max=null):y.facets.forEach(I=>{I.min=null,I.max=null})))})}let Or=!1,rl=!1,nr=[];function rg(){rl=!1;for(let v=0;v<nr.length;v++)an(...nr[v]);nr.length=0}function eo(){Or||(o0(ou),Or=!0)}function ag(v,y=!1){Or=!0,rl=y,v(n),ou(),y&&nr.length>0&&queueMicrotask(rg)}n.batch=ag;function ou(){if(oe&&(bs(),oe=!1),pe&&(Qt(),pe=!1),Yt){if(ke(p,co,it),ke(p,"top",St),ke(p,mr,nt),ke(p,gr,Y),ke(_,co,it),ke(_,"top",St),ke(_,mr,nt),ke(_,gr,Y),ke(d,mr,w),ke(d,gr,tt),h.width=Ke(w*Se),h.height=Ke(tt*Se),S.forEach(({_el:v,_show:y,_size:P,_pos:I,side:B})=>{if(v!=null)if(y){let J=B===3||B===0?P:0,rt=B%2==1;ke(v,rt?"left":"top",I-J),ke(v,rt?"width":"height",P),ke(v,rt?"top":"left",rt?St:it),ke(v,rt?"height":"width",rt?Y:nt),dc(v,Is)}else Fn(v,Is)}),$t=jt=Ft=we=Te=sn=ue=Vt=ae=null,Oe=1,or(!0),it!=bt||St!=At||nt!=Zt||Y!=pt){to(!1);let v=nt/Zt,y=Y/pt;if(ut&&!V&&mt.left>=0){mt.left*=v,mt.top*=y,no&&_i(no,Ke(mt.left),0,nt,Y),io&&_i(io,0,Ke(mt.top),nt,Y);for(let P=0;P<pn.length;P++){let I=pn[P];I!=null&&(Ai[P]*=v,Ri[P]*=y,_i(I,jn(Ai[P]),jn(Ri[P]),nt,Y))}}if(Ie.show&&!Mt&&Ie.left>=0&&Ie.width>0){Ie.left*=v,Ie.width*=v,Ie.top*=y,Ie.height*=y;for(let P in dl)ke(ro,P,Ie[P])}bt=it,At=St,Zt=nt,pt=Y}an("setSize"),Yt=!1}w>0&&tt>0&&(u.clearRect(0,0,h.width,h.height),an("drawClear"),D.forEach(v=>v()),an("draw")),Ie.show&&Mt&&(Br(Ie),Mt=!1),ut&&V&&(Ms(null,!0,!1),V=!1),xt.show&&xt.live&&st&&(hl(),st=!1),l||(l=!0,n.status=1,an("ready")),wt=!1,Or=!1}n.redraw=(v,y)=>{pe=y||!1,v!==!1?ji(L,R.min,R.max):eo()};function al(v,y){let P=x[v];if(P.from==null){if(z==0){let I=P.range(n,y.min,y.max,v);y.min=I[0],y.max=I[1]}if(y.min>y.max){let I=y.min;y.min=y.max,y.max=I}if(z>1&&y.min!=null&&y.max!=null&&y.max-y.min<1e-16)return;v==L&&P.distr==2&&z>0&&(y.min=oi(y.min,t[0]),y.max=oi(y.max,t[0]),y.min==y.max&&y.max++),$[v]=y,oe=!0,eo()}}n.setScale=al;let ll,cl,no,io,ru,au,so,oo,lu,cu,De,Be,Xi=!1;const un=mt.drag;let on=un.x,rn=un.y;ut&&(mt.x&&(ll=Xn(Cg,_)),mt.y&&(cl=Xn(Pg,_)),R.ori==0?(no=ll,io=cl):(no=cl,io=ll),De=mt.left,Be=mt.top);const Ie=n.select=Xe({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),ro=Ie.show?Xn(Rg,Ie.over?_:p):null;function Br(v,y){if(Ie.show){for(let P in v)Ie[P]=v[P],P in dl&&ke(ro,P,v[P]);y!==!1&&an("setSelect")}}n.setSelect=Br;function lg(v){if(M[v].show)ot&&dc(Ut[v],Is);else if(ot&&Fn(Ut[v],Is),ut){let P=Tn?pn[0]:pn[v];P!=null&&_i(P,-10,-10,nt,Y)}}function ji(v,y,P){al(v,{min:y,max:P})}function fi(v,y,P,I){y.focus!=null&&fg(v),y.show!=null&&M.forEach((B,J)=>{J>0&&(v==J||v==null)&&(B.show=y.show,lg(J),s==2?(ji(B.facets[0].scale,null,null),ji(B.facets[1].scale,null,null)):ji(B.scale,null,null),eo())}),P!==!1&&an("setSeries",v,y),I&&rr("setSeries",n,v,y)}n.setSeries=fi;function cg(v,y){Xe(F[v],y)}function hg(v,y){v.fill=le(v.fill||null),v.dir=be(v.dir,-1),y=y??F.length,F.splice(y,0,v)}function ug(v){v==null?F.length=0:F.splice(v,1)}n.addBand=hg,n.setBand=cg,n.delBand=ug;function dg(v,y){M[v].alpha=y,ut&&pn[v]!=null&&(pn[v].style.opacity=y),ot&&Ut[v]&&(Ut[v].style.opacity=y)}let Ci,Yi,ys;const ao={focus:!0};function fg(v){if(v!=ys){let y=v==null,P=Ln.alpha!=1;M.forEach((I,B)=>{if(s==1||B>0){let J=y||B==0||B==v;I._focus=y?null:J,P&&dg(B,J?1:Ln.alpha)}}),ys=v,P&&eo()}}ot&&Ti&&Nt(Cu,ht,v=>{mt._lock||(Ye(v),ys!=null&&fi(null,ao,!0,$e.setSeries))});function pi(v,y,P){let I=x[y];P&&(v=v/Se-(I.ori==1?St:it));let B=nt;I.ori==1&&(B=Y,v=B-v),I.dir==-1&&(v=B-v);let J=I._min,rt=I._max,dt=v/B,vt=J+(rt-J)*dt,Pt=I.distr;return Pt==3?Uo(10,vt):Pt==4?Xg(vt,I.asinh):Pt==100?I.bwd(vt):vt}function pg(v,y){let P=pi(v,L,y);return oi(P,t[0],K,Z)}n.valToIdx=v=>oi(v,t[0]),n.posToIdx=pg,n.posToVal=pi,n.valToPos=(v,y,P)=>x[y].ori==0?o(v,x[y],P?Ht:nt,P?yt:0):a(v,x[y],P?Et:Y,P?Ot:0),n.setCursor=(v,y,P)=>{De=v.left,Be=v.top,Ms(null,y,P)};function hu(v,y){ke(ro,co,Ie.left=v),ke(ro,mr,Ie.width=y)}function uu(v,y){ke(ro,"top",Ie.top=v),ke(ro,gr,Ie.height=y)}let ir=R.ori==0?hu:uu,sr=R.ori==1?hu:uu;function mg(){if(ot&&xt.live)for(let v=s==2?1:0;v<M.length;v++){if(v==0&&he)continue;let y=xt.values[v],P=0;for(let I in y)ce[v][P++].firstChild.nodeValue=y[I]}}function hl(v,y){if(v!=null&&(v.idxs?v.idxs.forEach((P,I)=>{gt[I]=P}):Zg(v.idx)||gt.fill(v.idx),xt.idx=gt[0]),ot&&xt.live){for(let P=0;P<M.length;P++)(P>0||s==1&&!he)&&gg(P,gt[P]);mg()}st=!1,y!==!1&&an("setLegend")}n.setLegend=hl;function gg(v,y){let P=M[v],I=v==0&&H==2?ft:t[v],B;he?B=P.values(n,v,y)??G:(B=P.value(n,y==null?null:I[y],v,y),B=B==null?G:{_:B}),xt.values[v]=B}function Ms(v,y,P){lu=De,cu=Be,[De,Be]=mt.move(n,De,Be),mt.left=De,mt.top=Be,ut&&(no&&_i(no,Ke(De),0,nt,Y),io&&_i(io,0,Ke(Be),nt,Y));let I,B=K>Z;Ci=Pe,Yi=null;let J=R.ori==0?nt:Y,rt=R.ori==1?nt:Y;if(De<0||z==0||B){I=mt.idx=null;for(let dt=0;dt<M.length;dt++){let vt=pn[dt];vt!=null&&_i(vt,-10,-10,nt,Y)}Ti&&fi(null,ao,!0,v==null&&$e.setSeries),xt.live&&(gt.fill(I),st=!0)}else{let dt,vt,Pt;s==1&&(dt=R.ori==0?De:Be,vt=pi(dt,L),I=mt.idx=oi(vt,t[0],K,Z),Pt=O(t[0][I],R,J,0));let Lt=-10,Dt=-10,Kt=0,Me=0,xe=!0,re="",qt="";for(let Gt=s==2?1:0;Gt<M.length;Gt++){let Ue=M[Gt],Ve=gt[Gt],ln=Ve==null?null:s==1?t[Gt][Ve]:t[Gt][1][Ve],Ae=mt.dataIdx(n,Gt,I,vt),Ge=Ae==null?null:s==1?t[Gt][Ae]:t[Gt][1][Ae];if(st=st||Ge!=ln||Ae!=Ve,gt[Gt]=Ae,Gt>0&&Ue.show){let Nn=Ae==null?-10:Ae==I?Pt:O(s==1?t[0][Ae]:t[Gt][0][Ae],R,J,0),bn=Ge==null?-10:q(Ge,s==1?x[Ue.scale]:x[Ue.facets[1].scale],rt,0);if(Ti&&Ge!=null){let Gn=R.ori==1?De:Be,Jn=Je(Ln.dist(n,Gt,Ae,bn,Gn));if(Jn<Ci){let mi=Ln.bias;if(mi!=0){let Dn=pi(Gn,Ue.scale),Wn=Ge>=0?1:-1,Qn=Dn>=0?1:-1;Qn==Wn&&(Qn==1?mi==1?Ge>=Dn:Ge<=Dn:mi==1?Ge<=Dn:Ge>=Dn)&&(Ci=Jn,Yi=Gt)}else Ci=Jn,Yi=Gt}}if(st||Tn){let Gn,Jn;R.ori==0?(Gn=Nn,Jn=bn):(Gn=bn,Jn=Nn);let mi,Dn,Wn,Qn,gi,yn,In=!0,Ss=Ne.bbox;if(Ss!=null){In=!1;let Mn=Ss(n,Gt);Wn=Mn.left,Qn=Mn.top,mi=Mn.width,Dn=Mn.height}else Wn=Gn,Qn=Jn,mi=Dn=Ne.size(n,Gt);if(yn=Ne.fill(n,Gt),gi=Ne.stroke(n,Gt),Tn)Gt==Yi&&Ci<=Ln.prox&&(Lt=Wn,Dt=Qn,Kt=mi,Me=Dn,xe=In,re=yn,qt=gi);else{let Mn=pn[Gt];Mn!=null&&(Ai[Gt]=Wn,Ri[Gt]=Qn,ku(Mn,mi,Dn,In),Iu(Mn,yn,gi),_i(Mn,jn(Wn),jn(Qn),nt,Y))}}}}if(Tn){let Gt=Ln.prox,Ue=ys==null?Ci<=Gt:Ci>Gt||Yi!=ys;if(st||Ue){let Ve=pn[0];Ve!=null&&(Ai[0]=Lt,Ri[0]=Dt,ku(Ve,Kt,Me,xe),Iu(Ve,re,qt),_i(Ve,jn(Lt),jn(Dt),nt,Y))}}}if(Ie.show&&Xi)if(v!=null){let[dt,vt]=$e.scales,[Pt,Lt]=$e.match,[Dt,Kt]=v.cursor.sync.scales,Me=v.cursor.drag;if(on=Me._x,rn=Me._y,on||rn){let{left:xe,top:re,width:qt,height:Gt}=v.select,Ue=v.scales[Dt].ori,Ve=v.posToVal,ln,Ae,Ge,Nn,bn,Gn=dt!=null&&Pt(dt,Dt),Jn=vt!=null&&Lt(vt,Kt);Gn&&on?(Ue==0?(ln=xe,Ae=qt):(ln=re,Ae=Gt),Ge=x[dt],Nn=O(Ve(ln,Dt),Ge,J,0),bn=O(Ve(ln+Ae,Dt),Ge,J,0),ir(ri(Nn,bn),Je(bn-Nn))):ir(0,J),Jn&&rn?(Ue==1?(ln=xe,Ae=qt):(ln=re,Ae=Gt),Ge=x[vt],Nn=q(Ve(ln,Kt),Ge,rt,0),bn=q(Ve(ln+Ae,Kt),Ge,rt,0),sr(ri(Nn,bn),Je(bn-Nn))):sr(0,rt)}else fl()}else{let dt=Je(lu-ru),vt=Je(cu-au);if(R.ori==1){let Kt=dt;dt=vt,vt=Kt}on=un.x&&dt>=un.dist,rn=un.y&&vt>=un.dist;let Pt=un.uni;Pt!=null?on&&rn&&(on=dt>=Pt,rn=vt>=Pt,!on&&!rn&&(vt>dt?rn=!0:on=!0)):un.x&&un.y&&(on||rn)&&(on=rn=!0);let Lt,Dt;on&&(R.ori==0?(Lt=so,Dt=De):(Lt=oo,Dt=Be),ir(ri(Lt,Dt),Je(Dt-Lt)),rn||sr(0,rt)),rn&&(R.ori==1?(Lt=so,Dt=De):(Lt=oo,Dt=Be),sr(ri(Lt,Dt),Je(Dt-Lt)),on||ir(0,J)),!on&&!rn&&(ir(0,0),sr(0,0))}if(un._x=on,un._y=rn,v==null){if(P){if(Mu!=null){let[dt,vt]=$e.scales;$e.values[0]=dt!=null?pi(R.ori==0?De:Be,dt):null,$e.values[1]=vt!=null?pi(R.ori==1?De:Be,vt):null}rr(_l,n,De,Be,nt,Y,I)}if(Ti){let dt=P&&$e.setSeries,vt=Ln.prox;ys==null?Ci<=vt&&fi(Yi,ao,!0,dt):Ci>vt?fi(null,ao,!0,dt):Yi!=ys&&fi(Yi,ao,!0,dt)}}st&&(xt.idx=I,hl()),y!==!1&&an("setCursor")}let Ki=null;Object.defineProperty(n,"rect",{get(){return Ki==null&&or(!1),Ki}});function or(v=!1){v?Ki=null:(Ki=_.getBoundingClientRect(),an("syncRect",Ki))}function du(v,y,P,I,B,J,rt){mt._lock||Xi&&v!=null&&v.movementX==0&&v.movementY==0||(ul(v,y,P,I,B,J,rt,!1,v!=null),v!=null?Ms(null,!0,!0):Ms(y,!0,!1))}function ul(v,y,P,I,B,J,rt,dt,vt){if(Ki==null&&or(!1),Ye(v),v!=null)P=v.clientX-Ki.left,I=v.clientY-Ki.top;else{if(P<0||I<0){De=-10,Be=-10;return}let[Pt,Lt]=$e.scales,Dt=y.cursor.sync,[Kt,Me]=Dt.values,[xe,re]=Dt.scales,[qt,Gt]=$e.match,Ue=y.axes[0].side%2==1,Ve=R.ori==0?nt:Y,ln=R.ori==1?nt:Y,Ae=Ue?J:B,Ge=Ue?B:J,Nn=Ue?I:P,bn=Ue?P:I;if(xe!=null?P=qt(Pt,xe)?r(Kt,x[Pt],Ve,0):-10:P=Ve*(Nn/Ae),re!=null?I=Gt(Lt,re)?r(Me,x[Lt],ln,0):-10:I=ln*(bn/Ge),R.ori==1){let Gn=P;P=I,I=Gn}}vt&&(y==null||y.cursor.event.type==_l)&&((P<=1||P>=nt-1)&&(P=Ls(P,nt)),(I<=1||I>=Y-1)&&(I=Ls(I,Y))),dt?(ru=P,au=I,[so,oo]=mt.move(n,P,I)):(De=P,Be=I)}const dl={width:0,height:0,left:0,top:0};function fl(){Br(dl,!1)}let fu,pu,mu,gu;function _u(v,y,P,I,B,J,rt){Xi=!0,on=rn=un._x=un._y=!1,ul(v,y,P,I,B,J,rt,!0,!1),v!=null&&(Nt(vl,hc,vu,!1),rr(Au,n,so,oo,nt,Y,null));let{left:dt,top:vt,width:Pt,height:Lt}=Ie;fu=dt,pu=vt,mu=Pt,gu=Lt}function vu(v,y,P,I,B,J,rt){Xi=un._x=un._y=!1,ul(v,y,P,I,B,J,rt,!1,!0);let{left:dt,top:vt,width:Pt,height:Lt}=Ie,Dt=Pt>0||Lt>0,Kt=fu!=dt||pu!=vt||mu!=Pt||gu!=Lt;if(Dt&&Kt&&Br(Ie),un.setScale&&Dt&&Kt){let Me=dt,xe=Pt,re=vt,qt=Lt;if(R.ori==1&&(Me=vt,xe=Lt,re=dt,qt=Pt),on&&ji(L,pi(Me,L),pi(Me+xe,L)),rn)for(let Gt in x){let Ue=x[Gt];Gt!=L&&Ue.from==null&&Ue.min!=Pe&&ji(Gt,pi(re+qt,Gt),pi(re,Gt))}fl()}else mt.lock&&(mt._lock=!mt._lock,Ms(y,!0,v!=null));v!=null&&(N(vl,hc),rr(vl,n,De,Be,nt,Y,null))}function _g(v,y,P,I,B,J,rt){if(mt._lock)return;Ye(v);let dt=Xi;if(Xi){let vt=!0,Pt=!0,Lt=10,Dt,Kt;R.ori==0?(Dt=on,Kt=rn):(Dt=rn,Kt=on),Dt&&Kt&&(vt=De<=Lt||De>=nt-Lt,Pt=Be<=Lt||Be>=Y-Lt),Dt&&vt&&(De=De<so?0:nt),Kt&&Pt&&(Be=Be<oo?0:Y),Ms(null,!0,!0),Xi=!1}De=-10,Be=-10,gt.fill(null),Ms(null,!0,!0),dt&&(Xi=dt)}function xu(v,y,P,I,B,J,rt){mt._lock||(Ye(v),kt(),fl(),v!=null&&rr(Pu,n,De,Be,nt,Y,null))}function bu(){S.forEach(f_),ct(n.width,n.height,!0)}zs(Ra,Lo,bu);const lo={};lo.mousedown=_u,lo.mousemove=du,lo.mouseup=vu,lo.dblclick=xu,lo.setSeries=(v,y,P,I)=>{let B=$e.match[2];P=B(n,y,P),P!=-1&&fi(P,I,!0,!1)},ut&&(Nt(Au,_,_u),Nt(_l,_,du),Nt(Ru,_,v=>{Ye(v),or(!1)}),Nt(Cu,_,_g),Nt(Pu,_,xu),vc.add(n),n.syncRect=or);const zr=n.hooks=i.hooks||{};function an(v,y,P){rl?nr.push([v,y,P]):v in zr&&zr[v].forEach(I=>{I.call(null,n,y,P)})}(i.plugins||[]).forEach(v=>{for(let y in v.hooks)zr[y]=(zr[y]||[]).concat(v.hooks[y])});const yu=(v,y,P)=>P,$e=Xe({key:null,setSeries:!1,filters:{pub:Hu,sub:Hu},scales:[L,M[1]?M[1].scale:null],match:[Vu,Vu,yu],values:[null,null]},mt.sync);$e.match.length==2&&$e.match.push(yu),mt.sync=$e;const Mu=$e.key,pl=Pp(Mu);function rr(v,y,P,I,B,J,rt){$e.filters.pub(v,y,P,I,B,J,rt)&&pl.pub(v,y,P,I,B,J,rt)}pl.sub(n);function vg(v,y,P,I,B,J,rt){$e.filters.sub(v,y,P,I,B,J,rt)&&lo[v](null,y,P,I,B,J,rt)}n.pub=vg;function xg(){pl.unsub(n),vc.delete(n),fe.clear(),fc(Ra,Lo,bu),c.remove(),ht?.remove(),an("destroy")}n.destroy=xg;function ml(){an("init",i,t),Bt(t||i.data,!1),$[L]?al(L,$[L]):kt(),Mt=Ie.show&&(Ie.width>0||Ie.height>0),V=st=!0,ct(i.width,i.height)}return M.forEach(er),S.forEach(sl),e?e instanceof HTMLElement?(e.appendChild(c),ml()):e(n,ml):ml(),n}vn.assign=Xe;vn.fmtNum=Sh;vn.rangeNum=Ca;vn.rangeLog=Wa;vn.rangeAsinh=yh;vn.orient=Ks;vn.pxRatio=Se;vn.join=s0;vn.fmtDate=Eh,vn.tzDate=m0;vn.sync=Pp;{vn.addGap=Z0,vn.clipGaps=Xa;let i=vn.paths={points:kp};i.linear=Op,i.stepped=t_,i.bars=e_,i.spline=i_}const p_="Hand in",m_="To hand in: press Stand up, push the robot, then Hand in within a minute, and change nothing else in between. It saves a file on this device: give it to your teacher.",g_="This robot's electronics are a file of their own: a hand-in of it cannot be run again.",__="There is no run to hand in: press Stand up, push the robot, then hand in within a minute.",v_="Certify",x_="{job} stopped: {why}",b_="Results as CSV",y_="To join the class",M_="upright lab",S_="Skip to the controls",w_="Connecting …",E_="The simulation is starting …",T_="Live",A_="No connection; trying again",R_="The lab does not answer. This page goes on by itself once upright lab runs again.",C_="Recording",P_="This page has stopped",L_="Light or dark",N_="What the buttons, keys and mouse do",D_="Close",I_="The robot in its room. Drag its body to push it; drag the floor to change the view.",U_="{body} leans {pitch} degrees and has rolled {way} centimetres.",k_="{body} has fallen.",F_="twin",O_="nonlinear model",B_="linear model",z_="published model",H_="calibrated model",V_="The robot as MuJoCo simulates it, with contact and friction: it stands for the hardware",G_="The full equations of motion of the model, without contact",W_="The same model, linearised about upright: valid for small angles",$_="The model with the equations as they were published",q_="The model with the parameters that Calibrate has found",X_="It balances by itself: drag it to push it",j_="More curves",Y_="Fewer curves",K_="robot: {body}",Z_="knock {size} N s",J_="held from the front",Q_="held from behind",tv="pulled left",ev="pulled right",nv="push {size} N s",iv="push",sv="stood up",ov="best knock {best} N s",rv="The largest single knock, or push by hand of at most half a second, that it has recovered from. A longer push holds the robot and does not count. Nor does one that comes before it has recovered from another.",av="Push a robot on two wheels, and see what keeps it upright",lv="New here? Take the tour",cv="1000 robots, each a little different, are held, released and knocked in simulation: about half a minute.",hv="Searching for the parameters with which the model predicts the log best.",uv="Searching the log for faults of units, signs, time and sensors.",dv="It begins soon; jobs run one at a time.",fv="{seconds} s so far",pv="about {seconds} s left",mv="{seconds} s so far, longer than expected",gv="300 robots, each a little different, are pushed in simulation. This takes a few seconds.",_v="It fell.",vv="Stand up",xv="Tilt",bv="The robot stands up again, tilted by 6°, and is let go",yv="Pause",Mv="Play",Sv="One step",wv="While paused: goes on by one step of the controller, some thousandths of a second",Ev="Speed",Tv="Back in time",Av="Time",Rv="It lies; press Stand up first.",Cv="Pushes",Pv="Hold from the front",Lv="A force on the front that holds a lean of 5.7° for 3 s and is then released (the paper's first push)",Nv="Hold from behind",Dv="A force on the back that holds a lean of −6.9° for 3 s and is then released (the paper's second push)",Iv="Knock",Uv="A short blow to the body, of the size beside it (K)",kv="Pull left",Fv="Pull right",Ov="Pull left, Pull right",Bv="A pull at one wheel for 0.3 s, a quarter of the robot's weight: it turns",zv="Size",Hv="Force times time: 0.05 N s is what an apple of 100 g brings at half a metre per second",Vv="pitch",Gv="pitch rate",Wv="wheel angle",$v="wheel rate",qv="yaw",Xv="yaw rate",jv="Traces of the last seconds",Yv="Settings, views and files",Kv="Controller",Zv="Robot",Jv="Kit",Qv="See",tx="Identify",ex="Keep",nx="Tour",ix="Class",sx="Method",ox="LQG: Kalman filter with dead time",rx="LQR with a Kalman filter",ax="LQI: LQG with an integral of the wheel angle",lx="PID cascade",cx="H∞",hx="MPC: predictive, keeps limits",ux="Sliding mode",dx="Robust: one gain for many robots",fx="Gains by hand: u = −K x",px="No controller",mx="There is no controller, so there is no loop.",gx="Largest accepted deviations (Bryson's rule): smaller means stricter",_x="command",vx="Back to the default weights",xx="This method has no weights to set here.",bx="The weights of this controller were fixed when it was designed. To change something here, choose Gains by hand. In the live lab (upright lab, with Python) you can set them.",yx="The new controller drives now: push the robot.",Mx="There is no certificate in this page. The live lab computes one for gains by hand, too: upright lab.",Sx="Each change here designs the controller anew, for the kit as it is then. So a longer dead time that is known does less harm.",wx="waits for the job in Identify",Ex="This run carried {mass} g that the robot's file does not have. Set Payload to 0 under Robot, push and drive for half a minute, then calibrate again.",Tx="Designing …",Ax="A robust design takes some ten seconds, longer on a busy machine. Until then another controller drives.",Rx="Gain K on the left motor",Cx="u = −K x, in {unit} per rad and rad/s. ψ pitch, θ wheel angle, φ yaw; a dot marks their rates.",Px="Saved; to save again:",Lx="Link copied. It opens this page on this computer; for others, put the page on a web host.",Nx="lean {size}°",Dx="Link copied. It opens on this computer. For others, start the lab with upright lab --class.",Ix="The comparison is ready: it stands in the tab Identify.",Ux="Comparison ready:",kx="Save {name}",Fx="Open",Ox="{what}: large or small",Bx="Fewer",zx="More",Hx="sets off by itself",Vx="There is no certificate in this page: the tab Python has its command.",Gx="unlimited",Wx="Certificate",$x="computing …",qx="{n} of {all} runs …",Xx="none",jx="This page has no robot '{name}'; it shows {shown}. It has: {all}.",Yx="This page leaves parts of the link out: {parts}.",Kx="This page has no controller '{name}' for this robot; it shows {shown}. It has: {all}.",Zx="The full certificate is ready. It stands in the tab Identify, too.",Jx="Full certificate",Qx="Robot",tb="Open robot.toml",eb="Parameters",nb="The controller is designed for these parameters.",ib="Back to the preset's parameters",sb="Payload unknown to the controller",ob="Height of the payload above the axle",rb="Slope of the floor",ab="Grip of the wheels, coefficient of friction (twin)",lb="Bodies to compare",cb="Electronics",hb="ideal: nothing between controller and motors",ub="Noise, rounding and bias of the sensors",db="Dead time from sensor to motor",fb="Battery",pb="Dead zone of the motors",mb="Back to the kit's values",gb="Loop: margins, Bode, Nyquist, poles",_b="What to see",vb="Bode plot of the loop broken at both motors",xb="Nyquist plot",bb="Closed-loop poles",yb="Phase portrait",Mb="Voltage",Sb="Voltage at the left and right motor; bars mark saturation.",wb="Torque of the left and right motor; bars mark saturation.",Eb="Estimate",Tb="The controller's estimate of the pitch, and the true pitch.",Ab="This controller estimates no state: it reads the true state, or nothing.",Rb="Equations",Cb="v in volts, or in the unit of the torque. Dry and rolling friction, slope and pushes are added to these.",Pb="truth",Lb="estimate",Nb="saturated",Db="Linearised about upright, ẋ = A x + B u",Ib="Open-loop poles",Ub="Log to use",kb="this run (the last minute)",Fb="Open a log",Ob="Doctor",Bb="Finds faults of the log: units, signs, delays, bias …",zb="Calibrate",Hb="Estimates the robot's parameters from its raw sensors; the calibrated model is shown as a further trace",Vb="Compare",Gb="A page with numbers and figures of all bodies over the last minute, and of the opened log",Wb="Stop",$b="Comparing …",qb="Another job is still running; the comparison may take longer.",Xb="Doctor: finds faults of the log. Calibrate: finds the robot's parameters in it; push and drive the robot for half a minute first, it then computes for some ten seconds to two minutes. Compare: a page of numbers and figures of all bodies.",jb="The files hold the run since the last change, at most the last minute.",Yb="Data, for a spreadsheet or for upright",Kb="Pages: numbers and figures, or the run to be seen again",Zb="Files, for the commands of upright",Jb="To show it: a picture, or a link to this set-up",Qb="Log as CSV: what the curves show, at most the last minute, for a spreadsheet or for upright. Picture: the robot as you see it now.",ty="A report and a replay page need Python: the live lab (upright lab) makes them.",ey="Log as CSV",ny="Log as Parquet",iy="Report",sy="Replay page",oy="Controller file",ry="Robot file",ay="Picture",ly="Copy link",cy="Link copied. It restores this whole set-up.",hy="It carries no push.",uy="It repeats the last push.",dy="Your push by hand is in it as a knock of the same impulse.",fy="Your push by hand was too long to be in it.",py="{name} is ready",my="Recovered from a push of {impulse} N s; largest so far {best} N s",gy="Recovered from a push of {impulse} N s, the largest so far",_y="It recovered, but not from a single push: no record.",vy="It fell after a push of {impulse} N s.",xy="It fell: several pushes, {impulse} N s in all, before it had recovered.",by="Reading {name}",yy="force {force} N",My="Board",Sy="Name",wy="Largest push [N s]",Ey="Effort",Ty="Send my set-up to everyone",Ay="Your name",Ry="Type your name first.",Cy="Join",Py="Join the class",Ly="Step {n} of {all}",Ny="Do",Dy="Watch",Iy="Think",Uy="Prepare",ky="Next",Fy="Back to my robot",Oy="Writing the file",By="Previous",zy=[["Mouse on the robot","drag and hold to push"],["Mouse on the floor","drag to change the view, scroll to zoom"],["One finger","on the robot: push it; beside it: change the view, sideways"],["← → ↑ ↓","turn and drive; a gamepad's left stick does the same"],["F, B","push from the front, from the back, while the key is held"],["K","knock"],["Space","pause and continue"],[".","one step"],[", and /","back and forth in time, while paused"],["S","stand up"],["1, 2, 3 …","open the first, second, third … tab"],["N, P","next and previous step of the tour; Enter sets it up"],["[ ] { } + −","change the view and zoom, while the room has the focus"],["?","this list"]],Hy="Python",Vy="Linear model as a ghost beside the robot",Gy="Payload unknown to the controller: {mass} g, {height} cm above the axle",Wy="The controller stays as it was designed: for a level floor and the kit's own dead time.",$y="Copy link",qy="A link to this robot and controller, and to the last push; a short one by hand becomes a knock",Xy="Link copied. Whoever opens it sees this robot and this controller.",jy="What follows needs upright, a program for Python 3.11 or newer. Whoever made this page has its folder: open a terminal in it, and type once:",Yy="pip install .",Ky="Copy",Zy="Copied.",Jy=[["A log of the twin of this robot, excited so that it can be calibrated from","upright example excited -o run.csv"],["A log of the twin of this robot, tilted, driven and turned so that it can be calibrated from","upright simulate -r {robot} -b twin -c lqg --start pitch=0.1 --drive {speed},start=1,until=4 --turn 1,start=2,until=5 -s 6 -o run.csv"],["Calibrate the robot from that log","upright calibrate run.csv --robot {robot}"],["Design this controller, with its margins, and save it","upright design {controller} -r {robot} -o controller.json"],["Certify this controller","upright certify {controller} -r {robot}"],["Your own robot, from a file, in a page like this","upright lab --export site --robots mine.toml"],["The live lab, with the MuJoCo twin, payloads, other electronics and every parameter","upright lab"]],Qy=[{title:"Push it",do:"Press Knock. Or drag the robot with the mouse or a finger, and let go.",watch:"The wheels roll under the body, and its lean ψ comes back to zero. θ is the angle of the wheels. Before the first push it may stand still: the motors do not answer to small voltages. Or it sets off by itself, where the noise of the sensors passes this dead zone. Once it moves it goes on to sway a little, because of both.",ask:"How large a knock can it bear? The slider Size sets it. The robot is the twin, which MuJoCo simulates in place of the hardware; the pale ghosts are simpler models. Where do their curves differ in the second after the knock?",here:{watch:"The wheels roll under the body, and its lean ψ comes back to zero. θ is the angle of the wheels. Before the first push it may stand still: the motors do not answer to small voltages. Or it sets off by itself, where the noise of the sensors passes this dead zone. Once it moves it goes on to sway a little, because of both.",ask:"How large a knock can it bear? The slider Size sets it. The pale ghost beside the robot is a simpler, linear model: where does its curve differ in the second after the knock?"}},{title:"It falls by itself",do:"Press Prepare: nothing controls the robot then. It starts with a lean of 1.1°, in slow motion (× 1/10).",watch:"After the first tenth of a second ψ grows like an exponential, because one open-loop pole lies in the right half-plane. Its curve is shown up to 17° here.",ask:"How long does the lean take from 6° to 12°? Compare with ln 2 divided by the unstable pole (See, Equations). Why is the first doubling, from rest, slower?"},{title:"Linearise",do:"Press Prepare: only the two models start, without a controller, from a small lean. They fall in slow motion (× 1/10).",watch:"The pitch ψ of both models agrees almost down to the floor. The wheel angle θ separates halfway.",ask:"Which terms does the linear model approximate? Look at sin ψ and cos ψ. Why does θ show it before ψ?"},{title:"Regulate",do:"Press Prepare: an LQR balances it now. Tilt it. Then set the accepted pitch under Controller to about 2.3°, and tilt it again.",watch:"A smaller accepted pitch makes a larger gain on ψ. After a tilt the body leans less far, but comes back more slowly, and θ rolls further: its sensors do not show how far it was tilted.",ask:"How do the margins change when the accepted pitch gets smaller? If the whole state were known, a larger gain would bring it back more quickly: what is not known here?",here:{do:"Press Prepare: an LQR balances it now. Tilt it. Then choose Gains by hand under Controller. Move ψ pitch → u to about −50 and tilt it again, then to about −9.",watch:"At −50 θ rolls twice as far (460°, not 230°), and the largest gain factor that it bears falls from 1.29 to 1.12. At −9 the body swings several times. Tilted, it leans further at first, until its sensors show the lean.",ask:"How do the margins change with the gain on ψ? What do its sensors not know after a tilt?"}},{title:"Push the front",do:"Press Prepare: after a second a force on the front holds ψ near 5.7° for 3 s, and is then released.",watch:"The robot leans into the force, at first a little further, and rolls backwards. After the release ψ swings beyond zero, to about −1°, and the wheels return.",ask:"Why does a push on the front hold a forward lean? Think of the sum of moments."},{title:"Push the back",do:"Press Prepare: after a second a force from behind holds ψ near −6.9° for 3 s, and is then released.",watch:"The same response, mirrored. Its lean is a fifth larger, and θ at least so much: that differs from run to run. φ, under More curves, hardly moves.",ask:"Is the response exactly the mirror image? What would make the two sides differ?"},{title:"Compare",do:"Press Prepare: twin and models are held in the same way, and released. When they stand again, open Identify and press Compare.",watch:"All three agree. What is left is mostly noise: settling times jump by tenths of a second from run to run. Press Prepare again and compare.",ask:"The push is small: why is the linear model as good as the nonlinear one? Which signal shows the noise most?"},{title:"Break the linear model",do:"Press Prepare: the robot carries 200 g, 30 cm above its axle, that neither the controller nor the linear model includes. Knock it gently, then harder.",watch:"It may begin to sway by itself. After a gentle knock the linear ghost almost comes to rest, and the twin goes on to sway widely. At 0.3 N s the ghost falls, though it bore this knock in the first step. The knock hits at the centre of mass of the loaded robot. That is higher, so it turns the ghost, which has no payload, twice as fast.",ask:"Why does the loaded robot bear this knock from rest, but not always while it sways? How large a payload does it carry at most?",here:{do:"Press Prepare: the robot carries 300 g, 30 cm above its axle, that neither the controller nor the linear model includes. Knock it gently, then harder.",watch:"It may begin to sway by itself. After a gentle knock the linear ghost almost comes to rest, and the robot goes on to sway widely. At 0.3 N s the ghost falls, though it bore this knock in the first step. The knock hits at the centre of mass of the loaded robot. That is higher, so it turns the ghost, which has no payload, twice as fast.",ask:"Why does the loaded robot bear this knock from rest, but not always while it sways? Can gains by hand carry the payload?"}},{title:"Make it robust",do:"Press Prepare: a robust design has one gain for many robots. It takes some ten seconds. The payload stays on. Repeat your pushes.",watch:"The loaded robot sways as widely as before, but rolls less far. It bears no larger knock: robust means that the margins hold for many robots. The light of the certificate says whether the controller may drive the real robot. For it, 300 robots that differ a little are pushed in simulation, without the payload.",ask:"What is the largest knock from rest that it bears, and that the regulator of the step before bears? What else did robustness cost? Compare effort and travel in a report (Keep)."}],tM="This robot cannot be simulated. The one before it stands here again.",eM="That was too much at once: some of it was left out. Wait a moment.",nM="The simulation stopped and was started again. All robots stand upright.",iM="Your last change stopped the simulation for all. The usual robot stands here instead.",sM="left motor",oM="right motor",rM="The margins are for the kit's own dead time, {own} ms. The slider has {now} ms.",aM="Expected: {what}.",lM="Likely: {what}.",cM="Try: {what}.",hM="{job} was stopped.",uM="no controller",dM="{light}, without the payload",fM="{light}, on a level floor",pM="{light}, without the payload, on a level floor",mM={small:"stable, with small margins",usual:"stable, with usual margins",thin:"stable, a margin is thin",unstable:"unstable",free:"it may roll or turn away",doubles:"Unstable: a small deviation doubles every {time}",unheld:"Nothing holds its position or its heading",delay:"more delay at {place} makes it unstable",strength:"of the motors' strength keep it stable",phase:"phase margin at both motors",both:"both motors",range:"{low} to {high}",atLeast:"at least {low}",holds:"{controller} holds {robot} near rest",anyDelay:"Any delay and any gain leave it stable.",stronger:"The thinnest margin: a signal {change} stronger at {place}.",weaker:"The thinnest margin: a signal {change} weaker at {place}."},gM="green",_M="amber",vM="red",xM="unknown",Za={handIn:p_,handInNote:m_,noReplay:g_,noRun:__,certify:v_,jobStopped:x_,results:b_,invite:y_,title:M_,skip:S_,connecting:w_,starting:E_,connected:T_,lost:A_,gone:R_,replaying:C_,refused:P_,theme:L_,help:N_,close:D_,scene:I_,sceneNow:U_,fellNow:k_,twin:F_,nonlinear:O_,linear:B_,published:z_,calibrated:H_,twinNote:V_,nonlinearNote:G_,linearNote:W_,publishedNote:$_,calibratedNote:q_,hint:X_,moreCurves:j_,fewerCurves:Y_,robotIs:K_,mark_impulse:Z_,mark_front:J_,mark_back:Q_,mark_pull_left:tv,mark_pull_right:ev,mark_hand:nv,mark_held:iv,mark_stood:sv,best:ov,bestTip:rv,what:av,newHere:lv,doing_certify:cv,doing_calibrate:hv,doing_doctor:uv,oneAtATime:dv,soFar:fv,stillTakes:pv,overdue:mv,lightNote:gv,fallen:_v,standUp:vv,tilt:xv,tiltTip:bv,pause:yv,play:Mv,step:Sv,stepTip:wv,speed:Ev,back:Tv,timeLine:Av,lies:Rv,pushes:Cv,front:Pv,frontTip:Lv,backPush:Nv,backTip:Dv,impulse:Iv,impulseTip:Uv,pullLeft:kv,pullRight:Fv,pullBoth:Ov,pullTip:Bv,size:zv,sizeTip:Hv,pitch:Vv,pitch_rate:Gv,wheel:Wv,wheel_rate:$v,yaw:qv,yaw_rate:Xv,charts:jv,tabs:Yv,tabController:Kv,tabRobot:Zv,tabKit:Jv,tabSee:Qv,tabIdentify:tx,tabKeep:ex,tabTour:nx,tabClass:ix,family:sx,lqg:ox,lqr:rx,"lqr-complementary":"LQR with a complementary filter","lqr-state":"LQR on the true state (simulation only)",lqi:ax,pid:lx,hinf:cx,mpc:hx,sliding:ux,robust:dx,gains:fx,off:px,noLoop:mx,weights:gx,command:_x,ownWeights:vx,noWeights:xx,fixedWeights:bx,designed:yx,noCertificateByHand:Mx,redesigned:Sx,queued:wx,calibratedLaden:Ex,designing:Tx,robustTakes:Ax,gain:Rx,gainNote:Cx,saved:Px,lookHere:Lx,mark_tilt:Nx,linkHere:Dx,comparedThere:Ix,compared:Ux,saveAs:kx,open:Fx,large:Ox,fewer:Bx,more:zx,mark_self:Hx,noCertificateHere:Vx,unlimited:Gx,certificate:Wx,none:$x,tried:qx,noCertificate:Xx,noSuchRobot:jx,leftOut:Yx,noSuchController:Kx,certified:Zx,fullCertificate:Jx,preset:Qx,openRobot:tb,numbers:eb,numbersNote:nb,ownNumbers:ib,payload:sb,payloadHeight:ob,slope:rb,grip:ab,bodies:lb,kit:cb,ideal:hb,noise:ub,delay:db,voltage:fb,deadZone:pb,ownKit:mb,loop:gb,viewLabel:_b,bode:vb,nyquist:xb,poles:bb,portrait:yb,voltages:Mb,voltagesNote:Sb,torquesNote:wb,estimate:Eb,estimateNote:Tb,noEstimate:Ab,equations:Rb,equationsNote:Cb,truth:Pb,opinion:Lb,saturated:Nb,linearised:Db,openPoles:Ib,source:Ub,thisRun:kb,openLog:Fb,doctor:Ob,doctorTip:Bb,calibrate:zb,calibrateTip:Hb,compare:Vb,compareTip:Gb,stop:Wb,comparing:$b,compareWaits:qb,calibrateNote:Xb,keepNote:jb,keepData:Yb,keepPages:Kb,keepFiles:Zb,keepShow:Jb,csvNote:Qb,keepLive:ty,csv:ey,parquet:ny,report:iy,replay:sy,controllerFile:oy,robotFile:ry,picture:ay,link:ly,linkCopied:cy,noPush:hy,namedPush:uy,knockPush:dy,heldPush:fy,made:py,recovered:my,recoveredMost:gy,recoveredSeveral:_y,lostPush:vy,lostPushes:xy,uploaded:by,newtons:yy,board:My,name:Sy,bestPush:wy,effort:Ey,broadcast:Ty,yourName:Ay,nameMissing:Ry,enter:Cy,joinTitle:Py,tourStep:Ly,tourDo:Ny,tourWatch:Dy,tourAsk:Iy,tourSet:Uy,next:ky,tourBack:Fy,writing:Oy,previous:By,keys:zy,tabPython:Hy,ghost:Vy,carries:Gy,stays:Wy,lookAtThis:$y,lookTip:qy,lookCopied:Xy,pythonNote:jy,install:Yy,copy:Ky,copied:Zy,python:Jy,tour:Qy,setBack:tM,tooMany:eM,restarted:nM,ended:iM,leftMotor:sM,rightMotor:oM,delayOwn:rM,expected:aM,likely:lM,tryThis:cM,wasStopped:hM,unlitOff:uM,litPayload:dM,litSlope:fM,litBoth:pM,loopSaid:mM,green:gM,amber:_M,red:vM,unknown:xM},bM="Entregar",yM="Para entregar: presione Poner de pie, empuje el robot y presione Entregar antes de un minuto, sin cambiar nada más. Guarda un archivo en este equipo: déselo a su docente.",MM="La electrónica de este robot es un archivo propio: su entrega no se puede repetir.",SM="No hay nada que entregar: presione Poner de pie, empuje el robot y entregue antes de un minuto.",wM="Certificar",EM="{job} se detuvo: {why}",TM="Resultados en CSV",AM="Para unirse a la clase",RM="upright lab",CM="Ir a los controles",PM="Conectando …",LM="La simulación está arrancando …",NM="En vivo",DM="Sin conexión; se intenta de nuevo",IM="El laboratorio no responde. Esta página sigue por sí sola cuando upright lab funcione otra vez.",UM="Grabación",kM="Esta página se ha detenido",FM="Claro u oscuro",OM="Qué hacen los botones, las teclas y el mouse",BM="Cerrar",zM="El robot en su sala. Arrastre su cuerpo para empujarlo; arrastre el suelo para cambiar la vista.",HM="{body} se inclina {pitch} grados y ha rodado {way} centímetros.",VM="{body} se ha caído.",GM="gemelo",WM="modelo no lineal",$M="modelo lineal",qM="modelo publicado",XM="modelo calibrado",jM="El robot como lo simula MuJoCo, con contacto y fricción: hace las veces del robot real",YM="Las ecuaciones de movimiento completas del modelo, sin contacto",KM="El mismo modelo, linealizado en vertical: válido para ángulos pequeños",ZM="El modelo con las ecuaciones tal como se publicaron",JM="El modelo con los parámetros que encontró Calibrar",QM="Se equilibra solo: arrástrelo para empujarlo",tS="Más curvas",eS="Menos curvas",nS="robot: {body}",iS="golpe {size} N s",sS="sostenido por delante",oS="sostenido por detrás",rS="tirón izquierdo",aS="tirón derecho",lS="empujón {size} N s",cS="empujón",hS="de pie",uS="mejor golpe {best} N s",dS="El mayor golpe solo, o empujón a mano de medio segundo como máximo, del que se recuperó. Un empujón más largo sostiene el robot y no cuenta. Tampoco uno dado antes de que se recupere de otro.",fS="Empuje un robot de dos ruedas y vea qué lo mantiene en pie",pS="¿Primera vez? Haga el recorrido",mS="1000 robots, cada uno algo distinto, se sostienen, se sueltan y reciben golpes en simulación: cerca de medio minuto.",gS="Se buscan los parámetros con los que el modelo predice mejor el registro.",_S="Se buscan fallas de unidades, signos, tiempo y sensores en el registro.",vS="Empieza pronto; los trabajos se hacen uno tras otro.",xS="{seconds} s hasta ahora",bS="faltan unos {seconds} s",yS="{seconds} s hasta ahora, más de lo previsto",MS="300 robots, cada uno algo distinto, reciben empujones en simulación. Tarda unos segundos.",SS="Se cayó.",wS="Poner de pie",ES="Inclinar",TS="El robot se pone de pie otra vez, inclinado 6°, y se suelta",AS="Pausa",RS="Continuar",CS="Un paso",PS="En pausa: avanza un paso del controlador, unas milésimas de segundo",LS="Velocidad",NS="Atrás en el tiempo",DS="Tiempo",IS="Está caído; presione antes Poner de pie.",US="Empujones",kS="Sostener por delante",FS="Una fuerza por delante que mantiene una inclinación de 5,7° durante 3 s y luego cesa (el primer empujón del artículo)",OS="Sostener por detrás",BS="Una fuerza por detrás que mantiene una inclinación de −6,9° durante 3 s y luego cesa (el segundo empujón del artículo)",zS="Dar un golpe",HS="Un golpe breve al cuerpo, del tamaño que está al lado (K)",VS="Tirón izq.",GS="Tirón der.",WS="Tirón izq., Tirón der.",$S="Un tirón de una rueda durante 0,3 s, de un cuarto del peso del robot: gira",qS="Tamaño",XS="Fuerza por tiempo: 0,05 N s es lo que trae una manzana de 100 g a medio metro por segundo",jS="inclinación",YS="velocidad de inclinación",KS="ángulo de las ruedas",ZS="velocidad de las ruedas",JS="rumbo",QS="velocidad de giro",tw="Trazas de los últimos segundos",ew="Ajustes, vistas y archivos",nw="Controlador",iw="Robot",sw="Electrónica",ow="Ver",rw="Identificar",aw="Guardar",lw="Recorrido",cw="Clase",hw="Método",uw="LQG: filtro de Kalman con retardo",dw="LQR con filtro de Kalman",fw="LQI: LQG con integral del ángulo de ruedas",pw="PID en cascada",mw="H∞",gw="MPC: predictivo, respeta límites",_w="Modo deslizante",vw="Robusto: una ganancia para muchos robots",xw="Ganancias a mano: u = −K x",bw="Sin controlador",yw="No hay controlador, así que no hay lazo.",Mw="Mayores desviaciones aceptadas (regla de Bryson): menor es más estricto",Sw="mando",ww="Volver a los pesos por defecto",Ew="Este método no tiene pesos que ajustar aquí.",Tw="Los pesos de este controlador quedaron fijados al diseñarlo. Para cambiar algo aquí, elija Ganancias a mano. En el laboratorio en vivo (upright lab, con Python) también se pueden cambiar.",Aw="El nuevo controlador ya actúa: empuje el robot.",Rw="En esta página no hay certificado. El laboratorio en vivo lo calcula también para ganancias a mano: upright lab.",Cw="Cada cambio aquí diseña de nuevo el controlador, para la electrónica tal como queda. Por eso un retardo mayor, si se conoce, daña menos.",Pw="espera al trabajo de Identificar",Lw="En este ensayo el robot llevaba {mass} g que su archivo no tiene. Ponga la carga en 0 en Robot, empuje y conduzca medio minuto, y calibre de nuevo.",Nw="Diseñando …",Dw="Un diseño robusto tarda unos diez segundos, más en una máquina ocupada. Hasta entonces actúa otro controlador.",Iw="Ganancia K del motor izquierdo",Uw="u = −K x, en {unit} por rad y rad/s. ψ inclinación, θ ángulo de las ruedas, φ rumbo; el punto marca su velocidad.",kw="Guardado; para guardarlo otra vez:",Fw="Enlace copiado. Abre esta página en este computador; para otras personas, póngala en un servidor web.",Ow="inclinación {size}°",Bw="Enlace copiado. Se abre en este computador. Para otros, inicie el laboratorio con upright lab --class.",zw="La comparación está lista: está en la pestaña Identificar.",Hw="Comparación lista:",Vw="Guardar {name}",Gw="Abrir",Ww="{what}: grande o pequeña",$w="Menos",qw="Más",Xw="se mueve solo",jw="En esta página no hay certificado: la pestaña Python tiene su comando.",Yw="sin límite",Kw="Certificado",Zw="calculando …",Jw="{n} de {all} ensayos …",Qw="ninguno",t1="Esta página no tiene el robot '{name}'; muestra {shown}. Tiene: {all}.",e1="Esta página deja fuera partes del enlace: {parts}.",n1="Esta página no tiene el controlador '{name}' para este robot; muestra {shown}. Tiene: {all}.",i1="El certificado completo está listo. También está en la pestaña Identificar.",s1="Certificado completo",o1="Robot",r1="Abrir robot.toml",a1="Parámetros",l1="El controlador se diseña para estos parámetros.",c1="Volver a los parámetros de fábrica",h1="Carga que el controlador desconoce",u1="Altura de la carga sobre el eje",d1="Pendiente del suelo",f1="Agarre de las ruedas, coeficiente de fricción (gemelo)",p1="Cuerpos",m1="Electrónica",g1="ideal: nada entre controlador y motores",_1="Ruido, redondeo y sesgo de los sensores",v1="Retardo del sensor al motor",x1="Batería",b1="Zona muerta de los motores",y1="Volver a los valores de la electrónica",M1="Lazo: márgenes, Bode, Nyquist, polos",S1="Qué se ve",w1="Diagrama de Bode del lazo abierto en ambos motores",E1="Diagrama de Nyquist",T1="Polos en lazo cerrado",A1="Plano de fase",R1="Voltaje",C1="Voltaje en el motor izquierdo y en el derecho; las barras marcan saturación.",P1="Par del motor izquierdo y del derecho; las barras marcan saturación.",L1="Estimación",N1="La inclinación estimada por el controlador y la verdadera.",D1="Este controlador no estima el estado: lee el verdadero, o nada.",I1="Ecuaciones",U1="v en voltios, o en la unidad del par. A esto se suman fricción seca y de rodadura, pendiente y empujones.",k1="verdad",F1="estimación",O1="saturación",B1="Linealizado en vertical, ẋ = A x + B u",z1="Polos en lazo abierto",H1="Registro que se usa",V1="este ensayo (el último minuto)",G1="Abrir un registro",W1="Doctor",$1="Busca fallas del registro: unidades, signos, retardos, sesgo …",q1="Calibrar",X1="Estima los parámetros del robot a partir de sus sensores; el modelo calibrado se muestra como otra traza",j1="Comparar",Y1="Una página con números y figuras de todos los cuerpos en el último minuto, y del registro abierto",K1="Parar",Z1="Comparando …",J1="Otro trabajo sigue en marcha; la comparación puede tardar más.",Q1="Doctor: busca fallas del registro. Calibrar: halla en él los parámetros del robot; antes empuje y conduzca el robot medio minuto, después calcula de diez segundos a dos minutos. Comparar: una página con números y figuras de todos los cuerpos.",tE="Los archivos contienen el ensayo desde el último cambio, como mucho el último minuto.",eE="Datos, para una hoja de cálculo o para upright",nE="Páginas: números y figuras, o el ensayo para verlo otra vez",iE="Archivos, para los comandos de upright",sE="Para mostrarlo: una imagen, o un enlace a esta configuración",oE="Registro CSV: lo que muestran las curvas, como máximo el último minuto, para una hoja de cálculo o para upright. Imagen: el robot como se ve ahora.",rE="El informe y la página con la grabación requieren Python: los hace el laboratorio en vivo (upright lab).",aE="Registro CSV",lE="Registro Parquet",cE="Informe",hE="Página con la grabación",uE="Archivo del controlador",dE="Archivo del robot",fE="Imagen",pE="Copiar enlace",mE="Enlace copiado. Restaura toda esta configuración.",gE="No lleva ningún empujón.",_E="Repite el último empujón.",vE="Su empujón a mano va en él como un golpe del mismo impulso.",xE="Su empujón a mano fue demasiado largo para ir en él.",bE="{name} está listo",yE="Se recuperó de un empujón de {impulse} N s; el mayor hasta ahora {best} N s",ME="Se recuperó de un empujón de {impulse} N s, el mayor hasta ahora",SE="Se recuperó, pero no de un solo empujón: no es récord.",wE="Se cayó tras un empujón de {impulse} N s.",EE="Se cayó: varios empujones, {impulse} N s en total, antes de recuperarse.",TE="Se está leyendo {name}",AE="fuerza {force} N",RE="Clasificación",CE="Nombre",PE="Mayor empujón [N s]",LE="Esfuerzo",NE="Enviar mi configuración a todos",DE="Su nombre",IE="Escriba primero su nombre.",UE="Entrar",kE="Unirse a la clase",FE="Paso {n} de {all}",OE="Haga",BE="Observe",zE="Piense",HE="Preparar",VE="Siguiente",GE="Volver a mi robot",WE="Escribiendo el archivo",$E="Anterior",qE=[["Mouse sobre el robot","arrastrar y mantener para empujar"],["Mouse sobre el suelo","arrastrar para cambiar la vista, rueda para acercarse"],["Un dedo","sobre el robot: empujarlo; al lado: cambiar la vista, de lado"],["← → ↑ ↓","girar y conducir; la palanca izquierda de un control de juegos hace lo mismo"],["F, B","empujar por delante, por detrás, mientras se mantenga la tecla"],["K","golpe"],["Espacio","pausa y continuar"],[".","un paso"],[", y /","atrás y adelante en el tiempo, en pausa"],["S","poner de pie"],["1, 2, 3 …","abrir la primera, segunda, tercera … pestaña"],["N, P","paso siguiente y anterior del recorrido; Intro lo prepara"],["[ ] { } + −","cambiar la vista y acercarse, con el foco en la sala"],["?","esta lista"]],XE="Python",jE="Modelo lineal como fantasma junto al robot",YE="Carga que el controlador desconoce: {mass} g, a {height} cm sobre el eje",KE="El controlador queda como se diseñó: para un suelo horizontal y el retardo propio de la electrónica.",ZE="Copiar enlace",JE="Un enlace a este robot y este controlador, y al último empujón; uno breve a mano pasa a ser un golpe",QE="Enlace copiado. Quien lo abra verá este robot y este controlador.",tT="Lo siguiente necesita upright, un programa para Python 3.11 o más nuevo. Quien hizo esta página tiene su carpeta: abra en ella una terminal y escriba una vez:",eT="pip install .",nT="Copiar",iT="Copiado.",sT=[["Un registro del gemelo de este robot, excitado para poder calibrar con él","upright example excited -o run.csv"],["Un registro del gemelo de este robot, inclinado, conducido y girado para poder calibrar con él","upright simulate -r {robot} -b twin -c lqg --start pitch=0.1 --drive {speed},start=1,until=4 --turn 1,start=2,until=5 -s 6 -o run.csv"],["Calibrar el robot a partir de ese registro","upright calibrate run.csv --robot {robot}"],["Diseñar este controlador, con sus márgenes, y guardarlo","upright design {controller} -r {robot} -o controller.json"],["Certificar este controlador","upright certify {controller} -r {robot}"],["Su propio robot, de un archivo, en una página como esta","upright lab --export site --robots mine.toml"],["El laboratorio en vivo, con el gemelo MuJoCo, cargas, otra electrónica y todos los parámetros","upright lab"]],oT=[{title:"Empújelo",do:"Presione Dar un golpe. O arrastre el robot con el mouse o con un dedo, y suéltelo.",watch:"Las ruedas avanzan bajo el cuerpo, y su inclinación ψ vuelve a cero. θ es el ángulo de las ruedas. Antes del primer empujón puede quedar quieto: los motores no responden a voltajes pequeños. O se mueve solo, donde el ruido de los sensores supera esa zona muerta. Una vez movido sigue oscilando un poco, por ambas causas.",ask:"¿Qué golpe aguanta como máximo? El deslizador Tamaño lo fija. El robot es el gemelo, que MuJoCo simula en lugar del robot real; los fantasmas pálidos son modelos más simples. ¿En qué se diferencian sus curvas en el segundo tras el golpe?",here:{watch:"Las ruedas avanzan bajo el cuerpo, y su inclinación ψ vuelve a cero. θ es el ángulo de las ruedas. Antes del primer empujón puede quedar quieto: los motores no responden a voltajes pequeños. O se mueve solo, donde el ruido de los sensores supera esa zona muerta. Una vez movido sigue oscilando un poco, por ambas causas.",ask:"¿Qué golpe aguanta como máximo? El deslizador Tamaño lo fija. El fantasma pálido junto al robot es un modelo más simple, lineal: ¿en qué se diferencia su curva en el segundo tras el golpe?"}},{title:"Se cae solo",do:"Presione Preparar: entonces nada controla el robot. Empieza con una inclinación de 1,1°, en cámara lenta (× 1/10).",watch:"Tras la primera décima de segundo ψ crece como una exponencial, porque un polo en lazo abierto está en el semiplano derecho. Su curva se muestra aquí hasta 17°.",ask:"¿Cuánto tarda la inclinación de 6° a 12°? Compare con ln 2 dividido entre el polo inestable (Ver, Ecuaciones). ¿Por qué tarda más la primera duplicación, desde el reposo?"},{title:"Linealizar",do:"Presione Preparar: solo arrancan los dos modelos, sin controlador, desde una inclinación pequeña. Caen en cámara lenta (× 1/10).",watch:"La inclinación ψ de ambos modelos coincide casi hasta el suelo. El ángulo de rueda θ se separa a mitad de camino.",ask:"¿Qué términos aproxima el modelo lineal? Mire sen ψ y cos ψ. ¿Por qué θ lo muestra antes que ψ?"},{title:"Regular",do:"Presione Preparar: ahora un LQR lo equilibra. Inclínelo. Luego ponga la inclinación aceptada en Controlador en unos 2,3°, e inclínelo otra vez.",watch:"Una inclinación aceptada menor da una ganancia mayor en ψ. Al inclinarlo, el cuerpo se inclina menos, pero regresa más despacio, y θ rueda más lejos: sus sensores no muestran cuánto se inclinó.",ask:"¿Cómo cambian los márgenes con una inclinación aceptada menor? Si se conociera todo el estado, una ganancia mayor lo haría regresar más rápido: ¿qué no se conoce aquí?",here:{do:"Presione Preparar: ahora un LQR lo equilibra. Inclínelo. Luego elija Ganancias a mano en Controlador. Lleve ψ inclinación → u a unos −50 e inclínelo otra vez; luego a unos −9.",watch:"Con −50 θ rueda el doble (460°, no 230°), y el mayor factor de ganancia que soporta baja de 1,29 a 1,12. Con −9 el cuerpo oscila varias veces. Al inclinarlo se inclina más al principio, hasta que sus sensores lo muestran.",ask:"¿Cómo cambian los márgenes con la ganancia en ψ? ¿Qué no saben sus sensores después de inclinarlo?"}},{title:"Empujar por delante",do:"Presione Preparar: tras un segundo una fuerza por delante mantiene ψ cerca de 5,7° durante 3 s y luego cesa.",watch:"El robot se inclina contra la fuerza, al principio un poco más, y rueda hacia atrás. Al soltarlo ψ pasa de cero hasta unos −1°, y las ruedas regresan.",ask:"¿Por qué un empujón por delante mantiene una inclinación hacia adelante? Piense en la suma de momentos."},{title:"Empujar por detrás",do:"Presione Preparar: tras un segundo una fuerza por detrás mantiene ψ cerca de −6,9° durante 3 s y luego cesa.",watch:"La misma respuesta, reflejada. La inclinación es un quinto mayor, y θ al menos otro tanto: cambia de un ensayo a otro. φ, en Más curvas, apenas se mueve.",ask:"¿Es la respuesta exactamente la imagen reflejada? ¿Qué haría diferentes los dos lados?"},{title:"Comparar",do:"Presione Preparar: el gemelo y los modelos se sostienen del mismo modo y se sueltan. Cuando estén de pie otra vez, abra Identificar y presione Comparar.",watch:"Los tres coinciden. Lo que queda es sobre todo ruido: los tiempos de asentamiento saltan décimas de segundo de un ensayo a otro. Presione Preparar otra vez y compare.",ask:"El empujón es pequeño: ¿por qué el modelo lineal es tan bueno como el no lineal? ¿Qué señal muestra más el ruido?"},{title:"Romper el modelo lineal",do:"Presione Preparar: el robot lleva 200 g, a 30 cm sobre el eje, que ni el controlador ni el modelo lineal incluyen. Dele un golpe suave, luego uno más fuerte.",watch:"Puede empezar a oscilar solo. Tras un golpe suave el fantasma lineal casi vuelve al reposo, y el gemelo sigue oscilando mucho. Con 0,3 N s cae el fantasma, aunque aguantó ese golpe en el primer paso. El golpe da en el centro de masa del robot cargado. Este está más alto, y por eso hace girar al fantasma, que no lleva carga, al doble de velocidad.",ask:"¿Por qué el robot cargado aguanta este golpe desde el reposo, pero no siempre mientras oscila? ¿Qué carga lleva como máximo?",here:{do:"Presione Preparar: el robot lleva 300 g, a 30 cm sobre el eje, que ni el controlador ni el modelo lineal incluyen. Dele un golpe suave, luego uno más fuerte.",watch:"Puede empezar a oscilar solo. Tras un golpe suave el fantasma lineal casi vuelve al reposo, y el robot sigue oscilando mucho. Con 0,3 N s cae el fantasma, aunque aguantó ese golpe en el primer paso. El golpe da en el centro de masa del robot cargado. Este está más alto, y por eso hace girar al fantasma, que no lleva carga, al doble de velocidad.",ask:"¿Por qué el robot cargado aguanta este golpe desde el reposo, pero no siempre mientras oscila? ¿Puede llevar la carga con ganancias a mano?"}},{title:"Hacerlo robusto",do:"Presione Preparar: un diseño robusto tiene una ganancia para muchos robots. Tarda unos diez segundos. La carga sigue puesta. Repita sus empujones.",watch:"El robot cargado oscila tanto como antes, pero rueda menos. No aguanta un golpe mayor: robusto significa que los márgenes valen para muchos robots. La luz del certificado dice si el controlador puede conducir el robot real. Para ella, 300 robots algo distintos reciben empujones en simulación, sin la carga.",ask:"¿Cuál es el mayor golpe que aguanta desde el reposo, y cuál aguanta el regulador del paso anterior? ¿Qué más costó la robustez? Compare esfuerzo y recorrido en un informe (Guardar)."}],rT="Este robot no se puede simular. El anterior está de nuevo aquí.",aT="Fue demasiado a la vez: una parte se omitió. Espere un momento.",lT="La simulación se detuvo y comenzó de nuevo. Todos los robots están de pie.",cT="Su último cambio detuvo la simulación para todos. Aquí está el robot habitual en su lugar.",hT="motor izquierdo",uT="motor derecho",dT="Los márgenes son para el retardo propio de la electrónica, {own} ms. El deslizador tiene {now} ms.",fT="Se esperaba: {what}.",pT="Probablemente: {what}.",mT="Pruebe: {what}.",gT="{job} se detuvo.",_T="sin controlador",vT="{light}, sin la carga",xT="{light}, en suelo horizontal",bT="{light}, sin la carga, en suelo horizontal",yT={small:"estable, con márgenes pequeños",usual:"estable, con márgenes usuales",thin:"estable, un margen es escaso",unstable:"inestable",free:"puede rodar o girar",doubles:"Inestable: una pequeña desviación se duplica cada {time}",unheld:"Nada mantiene su posición ni su rumbo",delay:"más de retardo en {place} lo vuelven inestable",strength:"de la fuerza de los motores lo mantienen estable",phase:"margen de fase en ambos motores",both:"ambos motores",range:"{low} a {high}",atLeast:"al menos {low}",holds:"{controller} sostiene {robot} cerca del reposo",anyDelay:"Es estable con cualquier retardo y cualquier ganancia.",stronger:"El margen más estrecho: una señal un {change} más fuerte en {place}.",weaker:"El margen más estrecho: una señal un {change} más débil en {place}."},MT="verde",ST="ámbar",wT="rojo",ET="desconocido",Vp={handIn:bM,handInNote:yM,noReplay:MM,noRun:SM,certify:wM,jobStopped:EM,results:TM,invite:AM,title:RM,skip:CM,connecting:PM,starting:LM,connected:NM,lost:DM,gone:IM,replaying:UM,refused:kM,theme:FM,help:OM,close:BM,scene:zM,sceneNow:HM,fellNow:VM,twin:GM,nonlinear:WM,linear:$M,published:qM,calibrated:XM,twinNote:jM,nonlinearNote:YM,linearNote:KM,publishedNote:ZM,calibratedNote:JM,hint:QM,moreCurves:tS,fewerCurves:eS,robotIs:nS,mark_impulse:iS,mark_front:sS,mark_back:oS,mark_pull_left:rS,mark_pull_right:aS,mark_hand:lS,mark_held:cS,mark_stood:hS,best:uS,bestTip:dS,what:fS,newHere:pS,doing_certify:mS,doing_calibrate:gS,doing_doctor:_S,oneAtATime:vS,soFar:xS,stillTakes:bS,overdue:yS,lightNote:MS,fallen:SS,standUp:wS,tilt:ES,tiltTip:TS,pause:AS,play:RS,step:CS,stepTip:PS,speed:LS,back:NS,timeLine:DS,lies:IS,pushes:US,front:kS,frontTip:FS,backPush:OS,backTip:BS,impulse:zS,impulseTip:HS,pullLeft:VS,pullRight:GS,pullBoth:WS,pullTip:$S,size:qS,sizeTip:XS,pitch:jS,pitch_rate:YS,wheel:KS,wheel_rate:ZS,yaw:JS,yaw_rate:QS,charts:tw,tabs:ew,tabController:nw,tabRobot:iw,tabKit:sw,tabSee:ow,tabIdentify:rw,tabKeep:aw,tabTour:lw,tabClass:cw,family:hw,lqg:uw,lqr:dw,"lqr-complementary":"LQR con filtro complementario","lqr-state":"LQR con el estado verdadero (solo simulado)",lqi:fw,pid:pw,hinf:mw,mpc:gw,sliding:_w,robust:vw,gains:xw,off:bw,noLoop:yw,weights:Mw,command:Sw,ownWeights:ww,noWeights:Ew,fixedWeights:Tw,designed:Aw,noCertificateByHand:Rw,redesigned:Cw,queued:Pw,calibratedLaden:Lw,designing:Nw,robustTakes:Dw,gain:Iw,gainNote:Uw,saved:kw,lookHere:Fw,mark_tilt:Ow,linkHere:Bw,comparedThere:zw,compared:Hw,saveAs:Vw,open:Gw,large:Ww,fewer:$w,more:qw,mark_self:Xw,noCertificateHere:jw,unlimited:Yw,certificate:Kw,none:Zw,tried:Jw,noCertificate:Qw,noSuchRobot:t1,leftOut:e1,noSuchController:n1,certified:i1,fullCertificate:s1,preset:o1,openRobot:r1,numbers:a1,numbersNote:l1,ownNumbers:c1,payload:h1,payloadHeight:u1,slope:d1,grip:f1,bodies:p1,kit:m1,ideal:g1,noise:_1,delay:v1,voltage:x1,deadZone:b1,ownKit:y1,loop:M1,viewLabel:S1,bode:w1,nyquist:E1,poles:T1,portrait:A1,voltages:R1,voltagesNote:C1,torquesNote:P1,estimate:L1,estimateNote:N1,noEstimate:D1,equations:I1,equationsNote:U1,truth:k1,opinion:F1,saturated:O1,linearised:B1,openPoles:z1,source:H1,thisRun:V1,openLog:G1,doctor:W1,doctorTip:$1,calibrate:q1,calibrateTip:X1,compare:j1,compareTip:Y1,stop:K1,comparing:Z1,compareWaits:J1,calibrateNote:Q1,keepNote:tE,keepData:eE,keepPages:nE,keepFiles:iE,keepShow:sE,csvNote:oE,keepLive:rE,csv:aE,parquet:lE,report:cE,replay:hE,controllerFile:uE,robotFile:dE,picture:fE,link:pE,linkCopied:mE,noPush:gE,namedPush:_E,knockPush:vE,heldPush:xE,made:bE,recovered:yE,recoveredMost:ME,recoveredSeveral:SE,lostPush:wE,lostPushes:EE,uploaded:TE,newtons:AE,board:RE,name:CE,bestPush:PE,effort:LE,broadcast:NE,yourName:DE,nameMissing:IE,enter:UE,joinTitle:kE,tourStep:FE,tourDo:OE,tourWatch:BE,tourAsk:zE,tourSet:HE,next:VE,tourBack:GE,writing:WE,previous:$E,keys:qE,tabPython:XE,ghost:jE,carries:YE,stays:KE,lookAtThis:ZE,lookTip:JE,lookCopied:QE,pythonNote:tT,install:eT,copy:nT,copied:iT,python:sT,tour:oT,setBack:rT,tooMany:aT,restarted:lT,ended:cT,leftMotor:hT,rightMotor:uT,delayOwn:dT,expected:fT,likely:pT,tryThis:mT,wasStopped:gT,unlitOff:_T,litPayload:vT,litSlope:xT,litBoth:bT,loopSaid:yT,green:MT,amber:ST,red:wT,unknown:ET},Nh={en:Za,es:Vp},TT=[["en","English"],["es","Español"]];let Mi=Za;function Bo(){return Mi===Vp?"es":"en"}function hd(i){Mi=Nh[i]??Za,document.documentElement.lang=Bo(),document.title=Mi.title}function Ja(){return Mi}function U(i,t={}){return is(Mi[i],t)}function is(i,t){return i.replace(/\{(\w+)\}/g,(e,n)=>AT(String(t[n]??"")))}function Qe(i){const t=Mi[i];return typeof t=="string"?t:i}function ds(i){return Mi===Za?i:i.replace(/(\d)\.(?=\d)/g,"$1,")}function si(i,t){return ds(i.toFixed(t).replace("-","−"))}function AT(i){return/^[−-]?\d+\.\d+$/.test(i)?ds(i):i}function RT(i){const t=Mi,e=Object.entries(Nh).map(([n,s])=>(Mi=s,[n,i()]));return Mi=t,Object.fromEntries(e)}function Wi(i){return i[Bo()]??i.en}function Dh(i){return i.charAt(0).toUpperCase()+i.slice(1)}function Sr(i){const{came:t,expected:e,likely:n,hint:s}=Wi(i),o=/[.!?…]$/.test(t)?t:`${t}.`;return[Dh(o),e&&U("expected",{what:e}),n&&U("likely",{what:n}),s&&U("tryThis",{what:s})].filter(Boolean).join(" ")}function k(i,t={},...e){const n=document.createElement(i);for(const[s,o]of Object.entries(t))s.startsWith("on")?n.addEventListener(s.slice(2),o):s.includes("-")||s==="role"||s==="for"||s==="list"?n.setAttribute(s,String(o)):o!==void 0&&(n[s]=o);return n.append(...e.filter(s=>!!s)),n}function Xt(i,...t){Hs(()=>i.replaceChildren(...t.filter(e=>!!e)))}function Sl(i,t,...e){i.style.minHeight=t?`${i.getBoundingClientRect().height}px`:"",Xt(i,t&&k("div"),...e)}function Hs(i){const t=document.activeElement?.dataset?.key;i(),t&&document.activeElement===document.body&&document.querySelector(`[data-key="${t}"]`)?.focus({preventScroll:!0})}const Gp=new WeakMap;function hn(i){const t=k("span",{className:"said"},i());return Gp.set(t,i),t}function La(i){for(const t of i.querySelectorAll(".said"))t.textContent=Gp.get(t)?.()??""}function te(i,t,e={}){return k("button",{type:"button",onclick:t,...e},i)}function bc(i,t){return i.ctrlKey||i.metaKey||i.altKey||i.composedPath()[0].matches(t)}let ud=0;function $s(i){return ud+=1,`${i}-${ud}`}function Wp(i,t){const e=k("input",{type:"text",inputMode:"decimal",autocomplete:"off",className:"number",...t,onchange:()=>{const s=e.value.trim().replace("−","-").replace(",","."),o=s!==""&&Number.isFinite(Number(s));e.setAttribute("aria-invalid",String(!o)),o&&(n(Number(s)),i(Number(s)))}}),n=s=>e.value=ds(String(s).replace("-","−"));return{root:e,set:s=>{document.activeElement!==e&&(n(s),e.removeAttribute("aria-invalid"))}}}function Kn(i,t,e){const n=$s("slider"),s=p=>t.log?Math.log(p):p,o=p=>t.log?Math.exp(p):p,a=s(t.high)-s(t.low),r=k("input",{type:"range",id:n,min:String(s(t.low)),max:String(s(t.high)),step:String(t.step??a/200),"data-key":t.key??""}),l=p=>!t.log&&Math.abs(p)<1e-6*a?0:p,c=t.typed===void 0?null:Wp(p=>{r.value=String(s(p)),r.setAttribute("aria-valuetext",t.show(p)),e(p)},{"aria-label":i,"data-key":`${t.key??""}-typed`}),h=c?k("span",{className:"typed"},c.root,` ${t.typed}`):k("output",{for:n}),u=p=>{c?c.set(Number(p.toPrecision(4))):h.textContent=t.show(p),r.setAttribute("aria-valuetext",t.show(p))};r.addEventListener("input",()=>{const p=l(o(Number(r.value)));u(p),e(p)});const d=p=>{document.activeElement!==r&&(r.value=String(s(Math.max(p,t.log?t.low:-1/0)))),u(p)};return{root:k("div",{className:"slider"},k("label",{for:n},i),h,r),set:d}}function fs(i,t,e,n,s=""){const o=$s("select"),a=k("select",{id:o,"data-key":s,onchange:()=>n(a.value)},...t.map(([r,l])=>k("option",{value:r,selected:r===e},l)));return k("div",{className:"choice"},k("label",{for:o},i),a)}function _e(i,t=3){return Number.isFinite(i)?ds($p(String(Number(i.toPrecision(t))))):"∞"}function Ih(i){return`${ds($p(String(Number((i*180/Math.PI).toFixed(1)))))}°`}function $p(i){const t=(e,n)=>` ×10${e==="-"?"⁻":""}${n.replace(/\d/g,s=>"⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(s)])}`;return i.replace(/(?<=\d)e([+-]?)0*(\d+)\b/g,(e,n,s)=>t(n,s)).replace(/(?<=^|[\s(…])-(?=\.?\d)/g,"−")}function qp(i,t,e=""){const n=i.length?k("thead",{},k("tr",{},...i.map(o=>k("th",{scope:"col"},o)))):null,s=k("tbody",{},...t.map(o=>k("tr",{},...o.map(a=>k("td",{},a)))));return k("div",{className:"table",tabIndex:0,"data-key":e&&`table-${e}`},k("table",{className:e},n,s))}function Uh(i,t){let e=0,n=null;return(...s)=>{n=s,!e&&(t(...s),n=null,e=window.setTimeout(function o(){if(e=0,n){const a=n;n=null,t(...a),e=window.setTimeout(o,i)}},i))}}const CT={twin:"#0072b2",nonlinear:"#d55e00",linear:"#00805c",calibrated:"#a0478a",published:"#6b6b00"},PT={twin:"#56b4e9",nonlinear:"#f2843c",linear:"#2fc79b",calibrated:"#dd93bd",published:"#c9c95a"},LT={nonlinear:[7,4],linear:[2,3],calibrated:[9,3,2,3],published:[12,5]};function NT(){return document.documentElement.dataset.theme==="dark"}function ls(i){const t=i==="nonlinear"&&"uprightExport"in globalThis?"twin":i;return(NT()?PT:CT)[t]??"#888888"}function kh(i,t){return i===t[0]?[]:LT[i]??[]}function ps(){const i=getComputedStyle(document.documentElement),t=e=>i.getPropertyValue(e).trim();return{text:t("--ink"),soft:t("--soft"),grid:t("--grid"),push:t("--push")}}const dd={front:[0,.5],back:[-.5,0],impulse:[-20,20],pull_left:[-100,100],pull_right:[-100,100],tilt:[-1.2,1.2]},DT=.5;class IT{push=null;kept="noPush";hand={from:0,at:0,force:0,impulse:0,on:!1};note(t,e){t.kind==="Strike"?this.name([t.what,t.size]):t.kind==="StandUp"&&t.pitch?this.name(["tilt",t.pitch]):t.kind==="Drag"&&this.drag(t.force,e)}name(t){[this.push,this.kept]=[t,t?"namedPush":"noPush"]}drag(t,e){const{hand:n}=this;if(!n.on&&!t)return;n.on||Object.assign(n,{from:e,at:e,force:0,impulse:0,on:!0}),n.impulse+=n.force*(e-n.at),[n.at,n.force,n.on]=[e,t,t!==0];const s=e-n.from<=DT;[this.push,this.kept]=s?[["impulse",Number(n.impulse.toPrecision(4))],"knockPush"]:[null,"heldPush"]}}function UT(i){const[t,e]=(new URLSearchParams(i.replace(/^#/,"")).get("push")??"").split(":"),[n,s]=Object.hasOwn(dd,t)?dd[t]:[0,-1];return Number(e)>=n&&Number(e)<=s?[t,Number(e)]:null}function kT([i,t]){return i==="tilt"?{kind:"StandUp",pitch:t}:{kind:"Strike",what:i,size:t}}const va={slope:[-.35,.35],noise:[0,20],delay:[-1,.2],voltage:[-1,60],dead_zone:[-1,5],grip:[.02,10],seed:[0,2**31],payload:[0,5],payload_height:[0,1]},Fh=Object.keys(va),Xp={gains:6,largest:7},fd=40,jp=i=>new URLSearchParams(i.replace(/^#/,"")),Wr=i=>i.length>fd?i.slice(0,fd)+"…":i,wl=i=>String(Number(i.toPrecision(6)));function Na(i){const t=["robot","controller","kit","bodies","numbers","push",...Fh,...Object.keys(Xp)];return[...jp(i).keys()].some(e=>t.includes(e))}function FT(i,t,{usual:e,robots:n,keys:s}){const o=new URLSearchParams({robot:i.robot,controller:i.controller}),a=(l,c)=>s.includes(l)&&o.set(l,c);i.kit!==n[i.robot]?.kit&&a("kit",i.kit),i.controller==="gains"&&i.gains.length&&a("gains",i.gains.map(wl).join()),i.largest.length&&a("largest",i.largest.map(wl).join()),i.drive&&a("drive",i.drive),Object.keys(i.numbers).length&&a("numbers",Object.entries(i.numbers).map(([l,c])=>`${l}:${String(c)}`).join());for(const l of Fh)i[l]!==e[l]&&a(l,wl(i[l]));const r=i.bodies.filter(l=>l!=="calibrated");return r.length&&r.join()!==e.bodies.join()&&a("bodies",r.join()),t&&o.set("push",`${t[0]}:${Number(t[1].toPrecision(4))}`),"#"+o.toString().replaceAll("%2C",",").replaceAll("%3A",":")}function OT(i,t){const e=jp(i),[n,s]=[e.get("robot")??"",e.get("controller")??""],o=BT(e.get("numbers")??"",t.parameters),a=t.keys.includes("drive")&&e.has("drive")&&Object.keys(o).length===t.parameters.length,r=Object.hasOwn(t.robots,n),l={...t.usual,robot:r||n&&a?n:t.usual.robot},c=t.robots[l.robot]??t.robots[t.usual.robot];c.controllers.includes(s)&&(l.controller=s),l.kit=c.kit??l.kit;const h=(g,[m,f])=>g.trim()&&Number(g)>=m&&Number(g)<=f?Number(g):void 0,u=(g,m)=>[g.split(",").map(Number)].find(f=>f.length===m&&f.every(Number.isFinite)),d={...Object.fromEntries(Fh.map(g=>[g,m=>h(m,va[g])])),...Object.fromEntries(Object.entries(Xp).map(([g,m])=>[g,f=>u(f,m)])),seed:g=>h(Number.isInteger(Number(g))?g:"",va.seed),payload:g=>h(g,c.load===void 0?va.payload:c.load?[c.load.payload,c.load.payload]:[0,0]),kit:g=>t.kits.find(m=>m===g),drive:g=>["voltage","torque","speed"].find(m=>m===g),numbers:g=>Object.keys(o).length===g.split(",").length?o:void 0,bodies:g=>[t.bodies.filter(m=>g.split(",").includes(m))].find(m=>m.length===g.split(",").length)},p=[];for(const[g,m]of e){if(!Object.hasOwn(d,g))continue;const f=t.keys.includes(g)?d[g](m):void 0;f===void 0?p.push(Wr(`${g}=${m}`)):Object.assign(l,{[g]:f})}const _=UT(i);return e.has("push")&&!_&&p.push(Wr(`push=${e.get("push")??""}`)),{setup:l,push:_,left:p,robot:l.robot===n?"":Wr(n),controller:l.controller===s?"":Wr(s)}}function BT(i,t){const e=i.split(",").map(n=>n.split(":"));return Object.fromEntries(e.filter(([n,s])=>t.includes(n)&&s?.trim()&&Number.isFinite(Number(s))).map(([n,s])=>[n,Number(s)]))}function zT(i){return/[#&]token=([\w-]+)/.exec(i)?.[1]??""}const HT=9,pd=.04,VT=.25,[GT,WT,$T]=[.5,2,30],Vi={robot:"nxtway-gs",numbers:{},drive:"",kit:"nxt",noise:1,delay:-1,voltage:-1,dead_zone:-1,grip:10,bodies:["twin","nonlinear","linear"],controller:"lqg",largest:[],gains:[],payload:0,payload_height:.15,slope:0,seed:0},qs=["pitch","pitch_rate","wheel","wheel_rate","yaw","yaw_rate"],qT=["rad","rad/s","rad","rad/s","rad","rad/s"],Yp=["°","°/s","°","°/s","°","°/s"],Qa=180/Math.PI,Vs=["ψ","ψ̇","θ","θ̇","φ","φ̇"],tl=.02,md=3200,XT=.15,gd=1e3,jT=.03,[YT,KT]=[.1,2],[ZT,_d]=[2,.05],JT=["bodies","payload","payload_height","slope","grip","seed"];function $r(i){return JSON.stringify(Object.entries(i).filter(([t])=>!JT.includes(t)))}function vd({robot:i,drive:t,kit:e,controller:n}){return[i,t,e,n].join()}function xd(i){return JSON.stringify(Object.entries(i).sort(([t],[e])=>t<e?-1:1))}class Oh{t=[];x=[];estimate=[];volts=[[],[]];saturated=[];marks=[];breaks=[];other=!1;from=-1/0;begin(t){this.reset(this.x.length),this.from=t,this.other=!1}reset(t){this.from=-1/0,this.t=[],this.x=Array.from({length:t},()=>qs.map(()=>[])),this.estimate=[],this.volts=[[],[]],this.saturated=[],this.breaks=[],this.marks=[]}add(t){const e=this.t.at(-1);if(!(t.t<=this.from||e!==void 0&&t.t<e)){if(t.t===e){const n=this.t.length-1;if(t.x.length!==this.x.length||this.x.every((s,o)=>s.every((a,r)=>a[n]===t.x[o][r])))return;this.pop()}t.x.length!==this.x.length&&this.reset(t.x.length),this.push(t.t,t.x,t.e[0]??NaN,t.x[0][6],t.x[0][7],t.s),this.t.length>md+400&&this.cut(this.t.length-md)}}push(t,e,n,s,o,a){(this.other||this.jumps(t,e))&&this.breaks.push([this.t.at(-1)??t,t]),this.other=!1,this.t.push(t),e.forEach((r,l)=>this.x[l].forEach((c,h)=>c.push(r[h]))),this.estimate.push(n),this.volts[0].push(s),this.volts[1].push(o),this.saturated.push(a)}pop(){for(const t of[this.t,...this.x.flat(),this.estimate,...this.volts,this.saturated])t.pop();this.other=!0}jumps(t,e){const[n,s]=[this.t.length-1,t-(this.t.at(-1)??t)],o=(a,r,l)=>Math.abs(a[l]-r[l][n])>YT+KT*s*Math.max(Math.abs(a[l+1]),Math.abs(r[l+1][n]));return n>=0&&e.some((a,r)=>[0,2,4].some(l=>o(a,this.x[r],l)))}fill(t,e){if(!e.length)return;const n=Math.floor(e[0].length/6);(n!==this.x.length||(this.t.at(-1)??0)>t.at(-1)+1)&&this.reset(n);const s=new Oh;s.reset(n);let o=0;const a=r=>{for(;o<t.length&&t[o]<r-.001;o+=1){if(t[o]<=this.from||t[o]-(s.t.at(-1)??-1/0)<jT)continue;const[l,c]=[e[o],e[o].slice(6*n)];s.push(t[o],Array.from({length:n},(h,u)=>l.slice(6*u,6*u+6)),c[0],c[1],c[2],c[3])}};this.t.forEach((r,l)=>{a(r),s.push(r,this.x.map(c=>c.map(h=>h[l])),this.estimate[l],this.volts[0][l],this.volts[1][l],this.saturated[l])}),a(1/0),s.breaks.push(...this.breaks),s.marks.push(...this.marks),Object.assign(this,s,{from:this.from,other:this.other})}until(t){let e=this.t.length;for(;e>0&&this.t[e-1]>=t;)e-=1;for(const n of this.all())n.length=e;this.marks=this.marks.filter(n=>n.t<t)}cut(t){for(const e of this.all())e.splice(0,t);this.marks=this.marks.filter(e=>e.t>=this.t[0])}all(){return[this.t,this.estimate,...this.volts,this.saturated,...this.x.flat()]}}const Kp={kind:"Light",light:"none",heads:{}};class QT{snapshot=null;traces=new Oh;changed=null;catalogue=null;analysed=null;equations=null;lit=null;trying=null;jobs=new Set;ceiling=null;board=null;found=null;certified=null;role="alone";session="";files="";invite="";setup=Vi;last=new IT;corrected=()=>{};say=()=>{};recorded=0;send=()=>{};listeners=[];sent=null;waiting=!1;asked=[];fresh=!1;lain=null;recalled=-gd;rest;missing=1/0;get falls(){return this.setup.controller==="off"||this.analysed?.stable===!1}anew(t){this.fresh=!0,t(),this.fresh&&this.traces.begin(1/0)}acted(t){this.sent?.what==="stood"&&(this.rest={wheel:0,from:t}),this.fresh?this.traces.begin(t):this.sent&&(this.sent.t=t),this.fresh=!1,this.sent=null}get settled(){return this.snapshot!==null&&!this.waiting&&this.changed?.busy===!1}note(t,e){const{hand:n}=this.last,{marks:s}=this.traces,o=n.on;["Change","Drag","Strike","Steer","StandUp"].includes(t.kind)&&(this.rest=null),this.last.note(t,e),t.kind==="Strike"?s.push({t:e,what:t.what,size:t.size}):t.kind==="StandUp"?s.push({t:e,what:t.pitch?"tilt":"stood",size:t.pitch}):n.on&&!o?s.push({t:e,what:"hand",size:0}):o&&s.at(-1)?.what==="hand"&&(s.at(-1).size=n.impulse),(t.kind==="Strike"||t.kind==="StandUp"||n.on&&!o)&&(this.sent=s.at(-1)??null)}listen(t){this.listeners.push(t)}change(t){t.robot!==void 0&&t.robot!==this.setup.robot&&this.last.name(null),this.expect(t),this.corrected(),this.ceiling=null,this.asked.push(xd(this.setup)),this.send({kind:"Change",setup:this.setup})}push(t){(t.kind==="Strike"||t.force!==0)&&this.snapshot?.x[0][8]?this.hear({kind:"Notice",level:"info",parts:{},key:"lies",job:""}):this.send(t)}expect(t){const e=$r(this.setup);this.setup={...this.setup,...t},$r(this.setup)!==e&&(this.waiting=!0,this.forget())}forget(){this.analysed=null,this.certified=null,this.trying=null,this.lit=Kp;for(const t of this.listeners)t(this.lit)}alone({t,x:[e]}){if(this.rest===void 0&&(this.rest=t<ZT&&!this.recorded?{wheel:e[2],from:t}:null),!this.rest||t<=this.rest.from||this.falls||Math.abs(e[2]-this.rest.wheel)<_d)return;const{rest:n,traces:s}=this,o=s.t.findIndex((a,r)=>a>n.from&&Math.abs(s.x[0][2][r]-n.wheel)>=_d);s.marks.push({t:s.t[o]??t,what:"self",size:0}),this.rest=null}recall(t){const e=this.traces.t.at(-1);e!==void 0&&t.t-e>=XT&&(this.missing=Math.min(this.missing,e)),!(this.missing===1/0||performance.now()-this.recalled<gd)&&(this.recalled=performance.now(),this.send({kind:"Recall",since:this.missing}),this.missing=1/0)}hear(t){switch(t.kind){case"Snapshot":this.snapshot=t,this.sent?.what==="hand"&&t.f[0]&&([this.sent.t,this.sent]=[t.t,null]),t.back||(this.lain=t.x.every(e=>e[8])?this.lain??t.t:null),t.back||(this.recall(t),this.traces.add(t),this.alone(t));break;case"Welcome":this.traces.from=-1/0,this.asked=[],this.jobs.clear(),this.role=t.role,this.session=t.session,this.files=t.files,this.invite=t.invite;break;case"Catalogue":this.catalogue=t;break;case"Changed":this.changedTo(t);break;case"Analysed":if(this.waiting)return;this.analysed=t;break;case"Equations":this.equations=t;break;case"Light":if(this.waiting)return;this.lit=t,this.trying=null;break;case"Progress":t.job==="light"&&t.runs&&!this.waiting&&(this.trying=t),t.job!=="light"&&t.job!=="design"&&(t.fraction<1?this.jobs.add(t.job):this.jobs.delete(t.job));break;case"Acted":this.acted(t.t);break;case"Board":this.board=t;break;case"JobResult":this.found=t,t.job==="certify"&&(this.certified=t);break;case"Notice":t.key==="tooMany"&&this.changed&&(this.asked=[],this.hear(this.changed));break;case"History":this.traces.fill(t.t,t.rows);break}for(const e of this.listeners)e(t)}outdated(t){const e=this.asked.indexOf(xd(t));return this.asked=e<0?[]:this.asked.slice(e+1),this.asked.length>0}changedTo(t){const e=this.changed?.bodies.join()===t.bodies.join(),n=this.changed,s=n!==null&&$r(n.setup)!==$r(t.setup);this.changed=t;const o=this.outdated(t.setup);this.traces.other||=n!==null&&(vd(n.setup)!==vd(t.setup)||n.busy&&!t.busy),s&&!this.waiting&&this.forget(),o||([this.waiting,this.setup]=[!1,t.setup]),e||this.traces.reset(t.bodies.length)}}const C=new QT,tA=13,eA=10.5,yc=["stood","self"],nA=5,iA=2;function sA({what:i,size:t}){const e=Qe(t||i!=="hand"?`mark_${i}`:"mark_held"),n=e.replace(/(?<=\{size\}).*/,""),s=Math.abs(i==="tilt"?Qa*t:t);return[...new Set([e,n])].map(o=>o.replace("{size}",_e(s,2)))}class oA{root=k("div",{className:"marks"});shown="";draw(t,e){const{ctx:n,bbox:{left:s,top:o,width:a,height:r}}=t,l=e*devicePixelRatio,{push:c,soft:h}=ps();let u=s+a+16*l;const d=[],p=C.traces.marks.map(_=>({mark:_,x:t.valToPos(_.t,"x",!0)})).filter(({x:_})=>_>=s&&_<=s+a);n.save(),n.lineWidth=l,n.setLineDash([3*l,3*l]),n.font=`${eA*l}px system-ui, sans-serif`;for(const{mark:_,x:g}of p.reverse()){n.strokeStyle=yc.includes(_.what)?h:c,n.beginPath(),n.moveTo(g,o),n.lineTo(g,o+r),n.stroke();const m=iA*l,f=Math.min(...p.map(S=>S.x).filter(S=>S>g+m))-m,M=Math.max(s,...p.map(S=>S.x).filter(S=>S<g-m).map(S=>S+m));for(const S of sA(_)){const x=n.measureText(S).width+3*l,F=Math.min(g,u-x,f-x);if(!(F<M||F+x<g)){d.push([S,_.what,F/devicePixelRatio]),u=F-nA*l;break}}}n.restore(),this.label(d)}label(t){const e=JSON.stringify(t.map(([n,s])=>[n,s]));e!==this.shown&&this.root.replaceChildren(...t.map(([n,s])=>k("span",{className:`event ${yc.includes(s)?"quiet":""}`},n))),this.shown=e,t.forEach(([,,n],s)=>this.root.children[s].style.left=`${n.toFixed(1)}px`)}}const rA="http://www.w3.org/2000/svg",ho=420,ze={left:58,right:10,top:8,bottom:34};function Da(i){const t=i.square?ho*.82:190,e=On("svg",{viewBox:`0 0 ${ho} ${t}`,role:"img","aria-label":i.title,class:"drawing"}),n=g=>i.logX?Math.log10(g):g,[s,o]=[n(i.x[0]),n(i.x[1])],[a,r]=[ho-ze.left-ze.right,t-ze.top-ze.bottom],l=g=>ze.left+(n(g)-s)/(o-s)*a,c=g=>ze.top+(1-(g-i.y[0])/(i.y[1]-i.y[0]))*r,h=ps(),u=`clip-${Math.random().toString(36).slice(2)}`,d=On("clipPath",{id:u});d.append(On("rect",{x:ze.left,y:ze.top,width:a,height:r})),e.append(d);for(const g of i.logX?cA(i.x):Ia(i.x,6))e.append(On("line",{x1:l(g),x2:l(g),y1:ze.top,y2:ze.top+r,stroke:h.grid})),e.append(qr(bd(g),l(g),ze.top+r+14,"middle",h.soft));for(const g of Ia(i.y,5))e.append(On("line",{x1:ze.left,x2:ho-ze.right,y1:c(g),y2:c(g),stroke:h.grid})),e.append(qr(bd(g),ze.left-6,c(g)+4,"end",h.soft));e.append(qr(i.xLabel,ze.left+a/2,t-4,"middle",h.soft));const p=qr(i.yLabel,0,0,"middle",h.soft);p.setAttribute("transform",`translate(9 ${ze.top+r/2}) rotate(-90)`),e.append(p);const _=On("g",{"clip-path":`url(#${u})`});e.append(_),i.circle&&_.append(On("ellipse",{cx:l(0),cy:c(0),rx:l(1)-l(0),ry:c(0)-c(1),fill:"none",stroke:h.soft,"stroke-dasharray":"4 3"}));for(const g of i.marks??[]){const m=g.y===void 0?{x1:l(g.x??0),x2:l(g.x??0),y1:ze.top,y2:ze.top+r}:{y1:c(g.y),y2:c(g.y),x1:ze.left,x2:ho-ze.right};_.append(On("line",{...m,stroke:h.push,"stroke-width":1.2,"stroke-dasharray":"5 3"}))}if((i.lines??[]).forEach((g,m)=>{const f=On("g",{id:`line-0-${m}-${u}`});f.append(aA(g,l,c)),_.append(f)}),i.read){const g={row:0,lines:[i.yLabel],left:ze.left,right:ho-ze.right,top:ze.top,bottom:ze.top+r,x:i.x,y:i.y,logx:i.logX,unit:i.xLabel};e.classList.add("lines"),e.dataset.curves=JSON.stringify([g])}for(const g of i.points??[])_.append(lA(g.cross??!1,l(g.x),c(g.y),g.colour));return e}function On(i,t={}){const e=document.createElementNS(rA,i);for(const[n,s]of Object.entries(t))e.setAttribute(n,String(s));return e}function qr(i,t,e,n,s){const o=On("text",{x:t,y:e,"text-anchor":n,fill:s,"font-size":11.5});return o.textContent=i,o}function aA(i,t,e){let n="",s=!1;return i.x.forEach((o,a)=>{const r=i.y[a],l=Number.isFinite(o)&&Number.isFinite(r);l&&(n+=`${s?"L":"M"}${t(o).toFixed(1)} ${e(r).toFixed(1)}`),s=l}),On("path",{d:n,fill:"none",stroke:i.colour,"stroke-width":1.8,"stroke-dasharray":(i.dash??[]).join(" "),"stroke-linejoin":"round"})}function lA(i,t,e,n){if(!i)return On("circle",{cx:t,cy:e,r:4,fill:n});const s=4.5;return On("path",{d:`M${t-s} ${e-s}L${t+s} ${e+s}M${t-s} ${e+s}L${t+s} ${e-s}`,stroke:n,"stroke-width":1.8})}function Ia([i,t],e){const n=(t-i)/e,s=10**Math.floor(Math.log10(n)),o=[1,2,5,10].map(r=>r*s).find(r=>r>=n)??n,a=[];for(let r=Math.ceil(i/o)*o;r<=t+o*1e-6;r+=o)a.push(Math.abs(r)<o*1e-6?0:r);return a}function cA([i,t]){const e=[];for(let n=Math.ceil(Math.log10(i));10**n<=t;n+=1)e.push(10**n);return e}function bd(i){return ds(String(+i.toPrecision(6)).replace("-","−"))}function Zp(i){try{const t=i();return t.getItem(""),t}catch{const t=new Map;return{getItem:e=>t.get(e)??null,setItem:(e,n)=>void t.set(e,n),removeItem:e=>void t.delete(e)}}}const os=Zp(()=>localStorage),ki=Zp(()=>sessionStorage);class Mc{root;plot;marks=new oA;extent=[NaN,NaN];constructor(t,e,n,s,o,a=()=>1/0){const r=ps(),l=parseFloat(getComputedStyle(document.documentElement).fontSize)/16,c={stroke:r.soft,grid:{stroke:r.grid,width:1},ticks:{show:!1},font:`${11*l}px system-ui, sans-serif`},h=k("div",{className:"plot","aria-hidden":"true"},this.marks.root);h.style.setProperty("--height",`${s/16}rem`),this.root=k("figure",{className:"strip",role:"group","aria-label":`${t} [${e}]`},k("figcaption",{},k("b",{},t),k("span",{},e)),h),this.plot=new vn({width:300,height:s,padding:[tA*l,18*l,0,0],cursor:{show:!1},legend:{show:!1},hooks:{draw:[u=>this.marks.draw(u,l)]},scales:{x:{time:!1},y:{range:()=>Jp(Math.max(this.extent[0],-a()),Math.min(this.extent[1],a()),o)}},axes:[{...c,size:20*l,values:(u,d)=>d.map(p=>p<0?"":ds(`${+p.toFixed(2)} s`)),space:46*l},{...c,size:46*l,splits:(u,d,p,_)=>uA(p,_,u.bbox.height/devicePixelRatio/(18*l)),values:(u,d)=>d.map(p=>ds(String(+p.toPrecision(4)).replace("-","−")))}],series:[{},...n.map(u=>({label:u.label,stroke:u.colour,width:(u.width??1.6)*l,dash:u.dash,points:{show:!1},spanGaps:!1,gaps:(d,p,_,g,m)=>[...m,...hA(d)].sort(([f],[M])=>f-M)}))]},[[],...n.map(()=>[])],h),new ResizeObserver(()=>this.fit(h)).observe(h)}fit(t){t.clientWidth>40&&this.plot.setSize({width:t.clientWidth,height:t.clientHeight})}show(t,e,n,s,o=e){const a=o.flat().filter(Number.isFinite);this.extent=a.length?[Math.min(...a),Math.max(...a)]:[NaN,NaN],this.plot.batch(()=>{this.plot.setData([t,...e],!1),this.plot.setScale("x",{min:n,max:s})})}}function hA(i){const{left:t,width:e}=i.bbox,n=2*devicePixelRatio;return C.traces.breaks.map(s=>s.map(o=>i.valToPos(o,"x",!0))).map(([s,o])=>[s-n/2,Math.max(o,s+n)]).filter(([s,o])=>s>t&&o<t+e)}function uA(i,t,e){let n=Math.max(1,Math.floor(e)),s=Ia([i,t],n);for(;s.length<2&&n<12;)s=Ia([i,t],n+=1);return s}function Jp(i,t,e){if(!Number.isFinite(i)||!Number.isFinite(t))return[-e,e];const n=(i+t)/2,s=Math.max((t-i)/2*1.1,e);return[n-s,n+s]}const El=[0,2],dA=[3,20,30,60,3,12],Gs=matchMedia("(max-width: 40rem), (max-width: 62rem) and (max-height: 32rem)"),Tl=matchMedia("(max-width: 40rem)"),yd=matchMedia("(min-width: 40.01rem)");class fA{constructor(t){this.seconds=t;for(const e of[Gs,yd])e.addEventListener("change",()=>this.build())}root=k("section",{className:"charts"});strips=[];legend=k("div",{className:"legend"});slot=k("div",{className:"slot"});large=null;build(){this.root.setAttribute("aria-label",U("charts"));const t=C.changed?.bodies??[],e=t.map(u=>({label:Qe(u),colour:ls(u),dash:kh(u,t)})),n=os.getItem("curves")==="all";Tl.matches||(this.large=null),this.strips=qs.map((u,d)=>n||El.includes(d)?new Mc(`${Vs[d]}  ${Qe(u)}`,Yp[d],e,104,dA[d],d?void 0:()=>Qa*(C.ceiling??1/0)):null),Xt(this.legend,...t.map(u=>Qp(u)));const s=Gs.matches?yd.matches?El.slice(0,1):El:[],o=this.strips.filter((u,d)=>s.includes(d)).map(u=>u?.root),a=this.strips.map(u=>u?.root).filter(u=>!o.includes(u));this.strips.forEach((u,d)=>u&&this.enlargeable(u.root,d));const r=U(n?"fewerCurves":"moreCurves"),l=te(Tl.matches?U(n?"fewer":"more"):r,()=>n?this.shown("first"):this.more(),{className:"quiet","aria-label":r,"aria-expanded":String(n),"data-key":"curves"}),c=u=>u.some(Boolean)?k("div",{className:`strips${n?" all":""}`},...u):null,h=k("div",{className:"above"},this.legend,l);Xt(this.slot,...o.length?[h,c(o)]:[]),Xt(this.root,o.length?null:h,c(a)),this.root.hidden=!this.root.childElementCount}more(){this.shown("all"),Gs.matches&&this.root.scrollIntoView()}shown(t){os.setItem("curves",t),Hs(()=>this.build())}enlargeable(t,e){const n=k("button",{type:"button",className:"enlarge","data-key":`enlarge-${e}`},k("span",{"aria-hidden":"true"},"⤢"),k("span",{className:"hidden"},U("large",{what:Qe(qs[e])})));t.classList.toggle("large",this.large===e),n.setAttribute("aria-expanded",String(this.large===e)),t.querySelector("figcaption")?.append(n),t.addEventListener("click",()=>{Tl.matches&&(this.large=this.large===e?null:e,Hs(()=>this.build()))})}draw(){const{t,x:e}=C.traces;if(!t.length||e.length!==C.changed?.bodies.length)return;const[n,s]=[this.seconds(),t.at(-1)],o=C.lain===null?s:Math.min(s,C.lain+.1*n),a=C.snapshot?.back?C.snapshot.t:Math.max(o,t[0]+n),r=a-n;let l=t.length;for(;l>0&&t[l-1]>=r;)l-=1;l=Math.max(0,l-1);const c=t.slice(l),h=C.traces.marks.findLast(g=>["stood","tilt"].includes(g.what)&&g.t<=a)?.t??-1/0,u=c.findIndex(g=>g>=Math.max(r,h)),d=C.snapshot?.x.map(g=>g[8]===1)??[],p=e.map((g,m)=>d.every(Boolean)||!d[m]),_=this.clipped(c,e[0]&&e.map(g=>g[0].slice(l)));this.strips.forEach((g,m)=>{const f=e.map(x=>xa(x[m].slice(l))),M=u<0?f:f.filter((x,F)=>p[F]).map(x=>x.slice(u)),S=_&&m===0&&m===this.large?_:[r,a];g?.show(c,f,...S,M)})}clipped(t,e){const{ceiling:n}=C;if(n===null||!t.length)return null;const s=Math.max(...e.map(o=>o.findIndex(a=>Math.abs(a)>n)+1||1/0));return s<=t.length&&s>1?[t[0],t[s-1]]:null}}function xa(i){return i.map(t=>Qa*t)}function Qp(i){const t=document.createElementNS("http://www.w3.org/2000/svg","svg");t.setAttribute("width","28"),t.setAttribute("height","10"),t.setAttribute("aria-hidden","true");const e=document.createElementNS("http://www.w3.org/2000/svg","line"),n={x1:"0",x2:"28",y1:"5",y2:"5",stroke:ls(i),"stroke-width":"2.5","stroke-dasharray":kh(i,C.changed?.bodies??[]).join(" ")};for(const[r,l]of Object.entries(n))e.setAttribute(r,l);t.append(e);const o={twin:U("twinNote"),nonlinear:U("nonlinearNote"),linear:U("linearNote"),published:U("publishedNote"),calibrated:U("calibratedNote")}[i]??"",a=i===C.changed?.bodies[0];return k("span",{className:"key",title:o},t,a?U("robotIs",{body:Qe(i)}):Qe(i))}const pA=60,mA=5e3;class gA{since=-1;lean=0;actions=[];begin(t,e,n){[this.since,this.lean]=[t,e],this.actions=n.speed||n.rate?[[0,{kind:"Steer",...n}]]:[]}stop(){this.since=-1}note(t,e){this.since>=0&&this.actions.length<mA&&this.actions.push([Co(e-this.since),t])}handIn(t,e,n,s,o){const a=Co(s-this.since);if(this.since<0||!(a>0&&a<=pA)||!t.trim())return null;const r={kind:"upright hand-in",version:1,student:t.trim(),setup:e,step:n,lean:this.lean,seconds:a,actions:this.actions,claimed:o};return Ua({...r,seal:xA(Ua(r))})}}function Co(i){return Number(i.toFixed(6))}const _A=["version","seed"];function Ua(i,t=""){return typeof i=="number"?_A.includes(t)?String(i):vA(i):Array.isArray(i)?`[${i.map(n=>Ua(n)).join(", ")}]`:i===null||typeof i!="object"?JSON.stringify(i):`{${Object.entries(i).sort(([n],[s])=>n<s?-1:1).map(([n,s])=>`${JSON.stringify(n)}: ${Ua(s,n)}`).join(", ")}}`}function vA(i){const[t,e]=i.toExponential().split("e").map((s,o)=>o?Number(s):s);if(i&&(e<-4||e>15))return`${t}e${e<0?"-":"+"}${String(Math.abs(e)).padStart(2,"0")}`;const n=Object.is(i,-0)?"-0":String(i);return n.includes(".")?n:`${n}.0`}function xA(i){const t=new TextEncoder().encode(i),e=Math.ceil((t.length+9)/64)*64,n=new Uint8Array(e);n.set(t),n[t.length]=128;const s=new DataView(n.buffer);s.setUint32(e-8,Math.floor(t.length/2**29)),s.setUint32(e-4,t.length<<3);const o=Md.slice(0,8).map(c=>Sd(Math.sqrt(c))),a=Md.map(c=>Sd(Math.cbrt(c))),r=new Int32Array(64),l=(c,h)=>c>>>h|c<<32-h;for(let c=0;c<e;c+=64){for(let M=0;M<16;M+=1)r[M]=s.getInt32(c+4*M);for(let M=16;M<64;M+=1){const[S,x]=[r[M-15],r[M-2]];r[M]=r[M-16]+(l(S,7)^l(S,18)^S>>>3)+r[M-7]+(l(x,17)^l(x,19)^x>>>10)}let[h,u,d,p,_,g,m,f]=o;for(let M=0;M<64;M+=1){const S=f+(l(_,6)^l(_,11)^l(_,25))+(_&g^~_&m)+a[M]+r[M]|0,x=(l(h,2)^l(h,13)^l(h,22))+(h&u^h&d^u&d)|0;[h,u,d,p,_,g,m,f]=[S+x|0,h,u,d,p+S|0,_,g,m]}[h,u,d,p,_,g,m,f].forEach((M,S)=>o[S]=o[S]+M|0)}return o.map(c=>(c>>>0).toString(16).padStart(8,"0")).join("")}const Md=Array.from({length:312},(i,t)=>t).filter(i=>i>1&&![2,3,5,7,11,13,17].some(t=>i%t===0&&i>t));function Sd(i){return(i-Math.floor(i))*2**32|0}const wd=1e-9,bA=1-1e-9,[yA,MA]=[.3,.001],[SA,wA]=[3e3,160],ba=(i,t)=>Array.from({length:i},()=>new Float64Array(t));function Sc(i,t){const e=ba(i.length,t[0].length);for(let n=0;n<i.length;n+=1){const[s,o]=[i[n],e[n]];for(let a=0;a<s.length;a+=1){const[r,l]=[s[a],t[a]];if(r)for(let c=0;c<o.length;c+=1)o[c]+=r*l[c]}}return e}const tm=i=>Math.max(...i.map(t=>t.reduce((e,n)=>e+Math.abs(n),0)));function Ed({A:i,B:t},e){const n=[...i.map((r,l)=>Float64Array.from([...r,...t[l]],c=>c*e)),...ba(2,8)],s=Math.max(0,Math.ceil(Math.log2(tm(n)+1e-300))+2);let[o,a]=[ba(8,8),ba(8,8)];for(let r=0;r<8;r+=1)a[r][r]=1;for(let r=1;r<20;r+=1)o=o.map((l,c)=>l.map((h,u)=>h+a[c][u])),a=Sc(a,n).map(l=>l.map(c=>c/r/2**s));for(let r=0;r<s;r+=1)o=Sc(o,o);return o.slice(0,6)}function Al(i,t){const e=Math.floor(i/t+wd),n=i-e*t;return[e,n>wd*t?n:0]}function Td(i,t,e,n=0,s=!1){const o=i.period,[a,r]=Al(i.dead+n,o),l=Al(i.dead,o)[0],c=S=>{const[x,F]=[Ed(i,Math.min(S,r)),Ed(i,Math.max(S-r,0))],L=(A,D,E)=>A.map(b=>b.reduce((R,H,O)=>R+H*(O<6?D[O]:E[O-6]),0));return(A,D,E)=>L(F,L(x,A,E),D)},h=i.delays.map(S=>{const[x,F]=Al(S,o);return F?{count:x+1,enters:c(o-F)}:{count:x,enters:null}}),u=c(o),[d,p]=[a+(r?1:0),new Float64Array(6)],_=6+h.reduce((S,x)=>S+x.count,0),g=_+2*d,m=g+t.start.length+2*l,f=S=>{const x=new Float64Array(m),F=(X,j)=>i.C[j].reduce((Q,at,lt)=>Q+at*X[lt],0);let L=6;const A=Float64Array.from(h,({count:X},j)=>(L+=X,X?S[L-1]:F(S,j))),[D,E]=[S.slice(g,g+t.start.length),new Float64Array(8)];t.command(D,A,p,E,e);const b=s?(E[0]+E[1])/2:0,R=[E[0]-b,E[1]-b],H=X=>X?[...S.slice(_+2*X-2,_+2*X)]:R,[O,q]=[H(a),r?H(a+1):[0,0]];x.set(u(S,O,q)),L=6,h.forEach(({count:X,enters:j},Q)=>{X&&(x.set(S.subarray(L,L+X-1),L+1),x[L]=F(j?j(S,O,q):S,Q)),L+=X}),d&&x.set([...R,...S.subarray(_,g-2)],_);const $=g+t.start.length;return t.update(D,A,p,E,e,l?S.slice(m-2):E.slice(0,2)),x.set(D,g),l&&x.set([...E.subarray(0,2),...S.subarray($,m-2)],$),x},M=Array.from({length:m},(S,x)=>f(new Float64Array(m).fill(1,x,x+1)));return Array.from({length:m},(S,x)=>Float64Array.from(M,F=>F[x]))}function Ad(i){let[t,e]=[i,0];for(let n=0;n<34;n+=1){const s=tm(t);if(e+=Math.log(s),!(s>0)||e<-1)return!0;if(e>60)return!1;t=t.map(o=>o.map(a=>a/s)),t=Sc(t,t),e*=2}return!1}function Rd(i){const t=i.length,e=i.map(r=>Float64Array.from(r));for(let r=1;r<t-1;r+=1){let l=r;for(let c=r+1;c<t;c+=1)Math.abs(e[c][r-1])>Math.abs(e[l][r-1])&&(l=c);if(e[l][r-1]){[e[r],e[l]]=[e[l],e[r]];for(const c of e)[c[r],c[l]]=[c[l],c[r]];for(let c=r+1;c<t;c+=1){const h=e[c][r-1]/e[r][r-1];if(h){for(let u=0;u<t;u+=1)e[c][u]-=h*e[r][u];for(const u of e)u[r]+=h*u[c]}}}}const n=i.map(()=>new Float64Array(t)),s=[];let[o,a]=[t-1,0];for(;o>=0;){let r=o;const l=u=>Math.hypot(e[u][u-1],n[u][u-1])<=Number.EPSILON*(Math.hypot(e[u][u],n[u][u])+Math.hypot(e[u-1][u-1],n[u-1][u-1]));for(;r>0&&!l(r);)r-=1;if(r===o){s.push([e[o][o],n[o][o]]),[o,a]=[o-1,0];continue}const[c,h]=a%11===10?[Math.abs(e[o][o-1])+e[o][o],n[o][o]]:EA(e,n,o);if(TA(e,n,r,o,c,h),a+=1,a>300)return s}return s}function EA(i,t,e){const n=(p,_)=>[i[p][_],t[p][_]],[s,o,a,r]=[n(e-1,e-1),n(e-1,e),n(e,e-1),n(e,e)],l=[(s[0]-r[0])/2,(s[1]-r[1])/2],c=RA(Cd(Rl(l,l),Rl(o,a))),h=l[0]*c[0]+l[1]*c[1]<0?-1:1,u=Cd(l,[h*c[0],h*c[1]]),d=u[0]||u[1]?AA(Rl(o,a),u):u;return[r[0]-d[0],r[1]-d[1]]}function TA(i,t,e,n,s,o){for(let r=e;r<=n;r+=1)[i[r][r],t[r][r]]=[i[r][r]-s,t[r][r]-o];const a=[];for(let r=e;r<n;r+=1){const[l,c,h,u]=[i[r][r],t[r][r],i[r+1][r],t[r+1][r]],d=Math.hypot(l,c,h,u)||1,[p,_,g,m]=[l/d,c/d,h/d,u/d];a.push([p,_,g,m]);for(let f=r;f<=n;f+=1){const[M,S,x,F]=[i[r][f],t[r][f],i[r+1][f],t[r+1][f]];i[r][f]=p*M+_*S+g*x+m*F,t[r][f]=p*S-_*M+g*F-m*x,i[r+1][f]=p*x-_*F-g*M+m*S,t[r+1][f]=p*F+_*x-g*S-m*M}}a.forEach(([r,l,c,h],u)=>{const d=e+u;for(let p=e;p<=Math.min(d+1,n);p+=1){const[_,g,m,f]=[i[p][d],t[p][d],i[p][d+1],t[p][d+1]];i[p][d]=r*_-l*g+c*m-h*f,t[p][d]=r*g+l*_+c*f+h*m,i[p][d+1]=r*m+l*f-c*_-h*g,t[p][d+1]=r*f-l*m-c*g+h*_}});for(let r=e;r<=n;r+=1)[i[r][r],t[r][r]]=[i[r][r]+s,t[r][r]+o]}const Cd=(i,t)=>[i[0]+t[0],i[1]+t[1]],Rl=(i,t)=>[i[0]*t[0]-i[1]*t[1],i[0]*t[1]+i[1]*t[0]],AA=(i,t)=>[(i[0]*t[0]+i[1]*t[1])/(t[0]**2+t[1]**2),(i[1]*t[0]-i[0]*t[1])/(t[0]**2+t[1]**2)];function RA([i,t]){const e=Math.hypot(i,t);return[Math.sqrt(Math.max(e+i,0)/2),(t<0?-1:1)*Math.sqrt(Math.max(e-i,0)/2)]}function Pd(i,t,e){return t.slice(1).flatMap((n,s)=>{if(e[s]<0==e[s+1]<0)return[];let[o,a]=[t[s],t[s+1]];for(let r=0;r<60;r+=1){const l=(o+a)/2;i(l)<0==e[s]<0?o=l:a=l}return[(o+a)/2]})}const em=(i,t,e)=>Array.from({length:e},(n,s)=>i*(t/i)**(s/(e-1))),nm=i=>em(.05,Math.PI/i,wA).filter((t,e)=>e%2===0);function CA(i,t){let[e,n]=[0,0];for(;i(n);){if(e>t)return 1/0;[e,n]=[n,n+MA]}for(let s=0;n&&s<12;s+=1){const o=(e+n)/2;i(o)?e=o:n=o}return e}const Ld=i=>Number.isFinite(i)?i:null;function PA(i,t,e){const[n,s]=[!1,!0].map(A=>Td(i,t,e,0,A)),o=Rd(n).sort((A,D)=>Math.hypot(...D)-Math.hypot(...A)),a=Rd(s),r=A=>{const D=[Math.cos(A*i.period),Math.sin(A*i.period)];let[E,b]=[1,0];for(let R=0;R<o.length;R+=1){const[H,O,q,$]=[D[0]-o[R][0],D[1]-o[R][1],D[0]-a[R][0],D[1]-a[R][1]],[X,j,Q]=[q*q+$*$,H*q+O*$,O*q-H*$];[E,b]=[(E*j-b*Q)/X,(E*Q+b*j)/X]}return[E-1,b]},l=Math.PI/i.period,c=nm(i.period),h=c.map(r),u={stable:Math.hypot(...o[0])<bA,poles:o,gain_low:1,gain_high:1,phase:0,delay:0,L:[c,h.map(([A])=>A),h.map(([,A])=>A)]};if(!u.stable)return u;const d=Array.from({length:300},(A,D)=>(D+1)*l/300),p=[...em(Math.min(.001,l/1e6),l,SA),...d].sort((A,D)=>A-D),_=p.map(r),m=[0,l,...Pd(A=>r(A)[1],p,_.map(([,A])=>A))].map(A=>r(A)[0]).filter(A=>A<0&&A>-1e6).map(A=>-1/A).sort((A,D)=>A-D),f=A=>A.find(D=>!Ad(s.map((E,b)=>E.map((R,H)=>R+(D+(D-1)/1e3)*(n[b][H]-R))))),M=([A,D])=>A*A+D*D-1,S=Pd(A=>M(r(A)),p,_.map(M)),x=S.map(A=>{const[D,E]=r(A);return(Math.atan2(E,D)+3*Math.PI)%(2*Math.PI)}),F=x.map((A,D)=>A/S[D]),L=CA(A=>Ad(Td(i,t,e,A)),Math.min(yA,...F));return{...u,gain_low:f(m.filter(A=>A<1).reverse())??0,gain_high:f(m.filter(A=>A>1))??null,phase:Ld(Math.min(...x.map(A=>Math.min(A,2*Math.PI-A)))),delay:Ld(Math.min(L,...F))}}const[LA,NA,DA,IA]=[.05,.4,1,.5];class Bh{best=0;run=0;effort=0;given=0;impulse=0;lasted=0;calm=0;before=0;push(){this.given||([this.impulse,this.lasted,this.before]=[0,0,this.effort]),this.given+=1,this.calm=0}exchanged(){this.given+=this.given?1:0,this.impulse=0}anew(t){return Object.assign(new Bh,{best:this.best,given:t?1:0})}watch(t,e,n,s,o,a){if(this.effort+=(o[0]**2+o[1]**2)*t,e)this.impulse+=Math.abs(e)*t,this.lasted+=t,this.calm=0;else if(this.given&&(this.calm=Math.abs(n)<LA&&Math.abs(s)<NA?this.calm+t:0,a||this.calm>=DA))return this.ended(a);return null}ended(t){const e=this.given===1;return this.given=0,!this.impulse||this.lasted>IA&&!t?null:(e&&!t&&(this.run=Math.max(this.run,this.impulse)),this.best=Math.max(this.best,this.run),{kind:"Recovered",impulse:this.impulse,effort:this.effort-this.before,best:this.best,fell:t,single:e})}}function UA(i){const t=Math.round(i);return Math.abs(i%1)===.5&&t%2?t-1:t}const kA=(i,t,e,n,s,o,a,r,l)=>{const c=Math.abs(i),h=n<c?i:0,u=Math.abs(t),d=n<u?t:0,p=Math.abs(h),_=p<a?p:a,g=Math.abs(d),m=g<a?g:a,f=_+m,M=r*f,S=a-M,x=e<S?e:S,F=-x,L=x<h?x:h,A=h<F?F:L,D=-s,E=D<0?s:1,b=A/E,H=Math.trunc(b)*E,O=D<0?H:A,q=x<d?x:d,$=d<F?F:q,X=$/E,Q=Math.trunc(X)*E,at=D<0?Q:$,lt=-o,gt=o<O?o:O,xt=O<lt?lt:gt,mt=O-xt,ot=lt<0?mt:O,ut=o<at?o:at,_t=at<lt?lt:ut,ht=at-_t,It=lt<0?ht:at,zt=p<g?g:p,Ut=x<zt?1:0;l[0]=ot,l[1]=It,l[2]=S,l[3]=Ut},FA=(i,t,e,n,s,o,a,r,l)=>{const c=Math.abs(i),h=n<c?i:0,u=Math.abs(t),d=n<u?t:0,p=Math.abs(h),_=p<a?p:a,g=Math.abs(d),m=g<a?g:a,f=_+m,M=r*f,S=a-M,x=-e,F=e<h?e:h,L=h<x?x:F,A=-s,D=A<0?s:1,E=L/D,R=Math.trunc(E)*D,H=A<0?R:L,O=e<d?e:d,q=d<x?x:O,$=q/D,j=Math.trunc($)*D,Q=A<0?j:q,at=-o,lt=o<H?o:H,gt=H<at?at:lt,xt=H-gt,mt=at<0?xt:H,ot=o<Q?o:Q,ut=Q<at?at:ot,_t=Q-ut,ht=at<0?_t:Q,It=p<g?g:p,zt=e<It?1:0;l[0]=mt,l[1]=ht,l[2]=S,l[3]=zt},OA=(i,t,e,n,s)=>{const o=i*e,a=t*n;s[0]=o,s[1]=a},BA=(i,t,e,n)=>{const s=t-e,o=t+e,a=o<i?o:i,r=i<s?s:a;n[0]=r},zA=(i,t,e,n,{quantum:s,noise:o,bias_walk:a,range:r,gain:l,offset:c},h)=>{const u=a*n,d=t+u,g=l*i+c+d,m=o*e,f=g+m,M=-s,S=M<0?s:1,x=f/S,L=UA(x)*S,A=M<0?L:f,D=-r,E=r<A?r:A,b=A<D?D:E;h[0]=b,h[1]=d},HA=(i,t,{tilt:e,b1:n,b2:s,a1:o,a2:a},r)=>{const l=s*i,c=a*i,h=l+c,u=n*i,d=o*i,_=u+d+h,g=e*t,m=i+g;r[0]=m,r[1]=_,r[2]=h},VA=(i,t,e,n,{tilt:s,b0:o,b1:a,b2:r,a1:l,a2:c},h)=>{const d=o*i+e,p=a*i,_=l*d,m=p+_+n,f=r*i,M=c*d,S=f+M,x=s*t,F=d+x;h[0]=F,h[1]=m,h[2]=S},GA=(i,t,e,n,s,o,a,{time_constant:r,spell:l},c)=>{const h=s*t,u=o*e,d=h+u,p=a*r,_=d/p,g=n-_,m=l*g,f=i+m;c[0]=f},WA=1.4,$A=.8,Nd=1e-9,[qA,XA,jA,YA]=[0,2,4,6];function KA(i,t,e,n){let s=0,o=0;for(const a of i){const r=a.start-Nd<=t&&t<a.start+a.duration-Nd;s+=r?a.force:0,o+=(r?a.force:0)*a.height}n[0]=s,n[1]=s?o/s:0,n[2]=e}function Dd(i,t){const[e,n,s,o]=[i>>>16,i&65535,t>>>16,t&65535],a=e*o+Math.floor(n*o/65536),r=n*s+a%65536;return e*s+Math.floor(a/65536)+Math.floor(r/65536)}function im([i,t,e,n],[s,o]){for(let a=0;a<10;a+=1)[i,t,e,n]=[(Dd(3449720151,e)^t^s)>>>0,Math.imul(3449720151,e)>>>0,(Dd(3528531795,i)^n^o)>>>0,Math.imul(3528531795,i)>>>0],s=s+2654435769>>>0,o=o+3144134277>>>0;return[i,t,e,n]}function ZA(i,t,e,n){const s=im([i,0,0,t+(e>>2)],[n,0]),[o,a]=e&2?s.slice(2):s,r=Math.sqrt(-2*Math.log((o+.5)/2**32)),l=Math.PI*(a/2**31-1);return r*(e&1?Math.sin(l):Math.cos(l))}function JA(i,t){const{from:e,every:n,b0:s,time_constant:o}=i,{x:a,ideal:r}=t,l=new Float64Array(3);return s!==void 0?(HA(a[1],a[5],i,l),()=>(t.steps&&VA(a[1],a[5],l[1],l[2],i,l),l[0])):o!==void 0?(l[0]=a[0],()=>{const[c,h]=[Math.cos(l[0]),Math.sin(l[0])];return t.steps&&t.steps%n===0&&GA(l[0],c,h,a[1],r[4],r[5],t.body.gravity,i,l),l[0]}):()=>e<0?t.voltage:r[e]}class QA{constructor(t,e,n){this.sensor=t,this.sense=JA(t,n);const s=this.sense();this.seed=e,this.count=0,this.held=0,this.touch=s,this.line=new Float64Array(t.delay+1).fill(s),this.bias=t.bias*this.normal(jA),this.out=new Float64Array(2)}normal(t){return ZA(this.count,t,this.sensor.kind,this.seed)}read(){const{play:t,delay:e,every:n}=this.sensor;let s=this.sense();return t&&(BA(this.touch,s,t,this.out),this.touch=s=this.out[0]),this.line[this.count%(e+1)]=s,this.count%n===0&&(this.held=this.fresh(this.line[(this.count+1)%(e+1)])),this.count+=1,this.held}fresh(t){const{bias_walk:e,noise:n,walks:s}=this.sensor,o=e&&this.count%s===0?this.normal(XA):0;return zA(t,this.bias,n?this.normal(qA):0,o,this.sensor,this.out),this.bias=this.out[1],this.out[0]}}class tR{constructor(t,e,n,s){this.body=t,this.control=e,this.x=Float64Array.from(n),this.steps=0,this.z=Float64Array.from(e.law?.start??[]),this.before=Float64Array.from(this.z),this.y=new Float64Array(e.reads.length),this.u=new Float64Array(8),this.sent=new Float64Array(2),this.applied=new Float64Array(2),this.driven=new Float64Array(2),this.out=new Float64Array(4),this.w=new Float64Array(3),this.ideal=new Float64Array(7),this.stopped=!1,this.twist=0,t.motion.read(this.x,this.applied,this.w,this.ideal),this.ideal[6]=this.x[0],this.voltage=t.kit?.voltage??1/0,this.waiting=[],this.latest=[0,0],this.arrived=[0,0],this.seed=s,this.channels=(t.kit?.sensors??[]).map(o=>new QA(o,s,this)),this.values=new Float64Array(6+(t.kit?this.channels.length:7)),this.sense()}get t(){return this.steps*this.body.period}get fallen(){return Math.abs(this.x[0])>WA}sense(){this.values.set(this.x),this.body.kit||this.values.set(this.ideal,6),this.channels.forEach((t,e)=>this.values[6+e]=t.read())}step(t,e){const{law:n,reads:s,stride:o,gains:a=[]}=this.control;this.before.set(this.z);for(let r=0;r<s.length;r+=1)this.y[r]=this.values[s[r]];n?.command(this.z,this.y,t,this.u,a),this.stopped||=Math.abs(this.x[0])>$A,this.stopped?this.sent.fill(0):this.sent.set(this.u.subarray(0,2));for(let r=0;r<o;r+=1)e(this.t,this.w),this.move();n?.update(this.z,this.y,t,this.u,a,this.applied)}move(){const{motion:t,kit:e}=this.body;e?this.drive(e):this.applied.set(this.sent),OA(this.applied[0],this.applied[1],e?.left??1,e?.right??1,this.driven),this.driven[0]+=this.twist,this.driven[1]-=this.twist,t.step(this.x,this.driven,this.w,this.ideal),this.ideal[6]=this.x[0],this.steps+=1,this.sense()}drive(t){const[e,n]=this.delayed(t),[s,o]=[t.limit??1/0,t.voltage??1/0];(t.volts?kA:FA)(e,n,s,t.dead_zone,t.quantum,t.drop,o,t.sag,this.out),[this.applied[0],this.applied[1],this.voltage]=this.out}delayed(t){const[e,n]=this.sent;if(e!==this.latest[0]||n!==this.latest[1]){const[s]=im([this.steps,0,0,YA],[this.seed,0]),o=Math.floor(s*(t.jitter+1)/2**32);this.waiting.push([this.steps+t.delay+o,e,n]),this.latest=[e,n]}for(;this.waiting.length&&this.waiting[0][0]<=this.steps;)this.arrived=this.waiting.splice(0,1)[0].slice(1);return this.arrived}}function eR(i){const t=new Float64Array(6);let e=0;const n=(s,o,a,r)=>{const l=i.turn*s[4],[c,h]=[Math.cos(s[0]),Math.sin(s[0])],u=i.radius*e+i.gravity*Math.sin(a[2])*Math.cos(s[4]),d=i.gravity*Math.cos(a[2]);r.set([s[2]-l-s[0],s[2]+l-s[0],s[1],s[4],u*c-d*h,u*h+d*c])};return{step(s,o,a,r){const l=[a[0],a[0]*a[1],a[2]];for(let c=0;c<6;c+=1){let h=0;for(let u=0;u<6;u+=1)h+=i.A[c][u]*s[u];t[c]=h+i.B[c][0]*o[0]+i.B[c][1]*o[1]+i.E[c][0]*l[0]+i.E[c][1]*l[1]+i.E[c][2]*l[2]}e=(t[3]-s[3])/i.period,s.set(t),n(s,o,a,r)},read:n}}{const i=new WeakMap;let t=()=>{};const e=r=>[...r.getAttribute("d").matchAll(/[ML] ?(-?[\d.]+) (-?[\d.]+)/g)].map(([,l,c])=>[+l,+c]),n=r=>{const l=JSON.parse(r.dataset.curves);for(const h of l){const u=h.lines.map((d,p)=>r.querySelector(`[id^=line-${h.row}-${p}-] path`));h.paths=u.map(d=>d?e(d):[])}const c=r.appendChild(document.createElementNS(r.namespaceURI,"line"));return i.set(r,{panels:l,rule:c,out:r.nextElementSibling}),i.get(r)},s=([r,l],c,h)=>c?r*(l/r)**h:r+h*(l-r),o=(r,l)=>{const{panels:c,rule:h,out:u}=i.get(r)??n(r),d=new Intl.NumberFormat(r.closest("[lang]")?.lang??document.documentElement.lang,{maximumSignificantDigits:3,useGrouping:!1}),p=D=>d.format(D).replace("-","−"),_=r.getBoundingClientRect(),g=(l.clientX-_.left)/_.width*r.viewBox.baseVal.width,{left:m,right:f,top:M,x:S,logx:x,unit:F}=c[0];if(g<m||g>f)return;const L=[];for(const{label:D,lines:E,paths:b,y:R,logy:H,top:O,bottom:q}of c)for(const[$,X]of b.entries()){const j=X.findIndex(_t=>_t[0]>=g);if(j<0||X[0][0]>g+1)continue;const[[Q,at],[lt,gt]]=[X[Math.max(j-1,0)],X[j]],xt=lt>Q?at+(g-Q)/(lt-Q)*(gt-at):gt,mt=(q-xt)/(q-O),ut=(mt>1.01?"> ":mt<-.01?"< ":"")+p(s(R,H,Math.min(Math.max(mt,0),1)));L.push(`${c.length>1?`${D}, `:""}${E[$]}: ${ut}`)}const A={class:"rule",x1:g,x2:g,y1:M,y2:c[c.length-1].bottom};for(const[D,E]of Object.entries(A))h.setAttribute(D,E);u.textContent=[`${F} ${p(s(S,x,(g-m)/(f-m)))}`,...L].join("   "),t=()=>{h.setAttribute("class","hidden"),u.textContent=""}},a=r=>{t(),t=()=>{};const l=r.composedPath()[0].closest?.("svg.lines");l&&o(l,r)};for(const r of["pointerdown","pointermove"])document.addEventListener(r,a);document.documentElement.addEventListener("pointerleave",a)}function sm({verdict:i,level:t,title:e,lead:n,numbers:s}){return k("div",{className:"first"},i&&k("p",{className:`badge ${t}`},i),e&&k("p",{},k("b",{},e)),...n.map(o=>k("p",{className:"note"},o)),s.length>0&&k("dl",{className:"facts"},...s.flatMap(([o,a])=>[k("dt",{},o),k("dd",{},a)])))}class om{constructor(t=()=>({})){this.acts=t}host=k("div",{className:"page"});root=this.host.attachShadow({mode:"open"});shown=null;show(t){if(t===this.shown&&this.host.lang===Bo())return this.host;const e=t===this.shown?[...this.root.querySelectorAll("details")].map(s=>s.open):[];this.shown=t,this.host.lang=Bo(),this.host.replaceChildren(),this.root.innerHTML=Wi(t.html),this.root.querySelectorAll("details").forEach((s,o)=>s.open=e[o]??!1);const n=this.acts(t.job);for(const s of this.root.querySelectorAll("[data-verb]")){const{verb:o=""}=s.dataset;if(!Object.hasOwn(n,o))continue;const[a,r]=n[o];s.append(Object.assign(document.createElement("slot"),{name:o})),this.host.append(te(a,r,{slot:o,"data-key":`next-${o}`}))}return this.host}}const Id=1e-6,nR=11;function iR({stable:i,poles:t}){return!i&&t.length>0}function rm(i){const t=Ze?.facts.robots[C.setup.robot]?.delay_own??0,{delay:e}=C.setup,n=Ze&&e>=0&&Math.abs(e-t)>5e-4,s=k("p",{className:"note"},U("delayOwn",{own:_e(1e3*t,2),now:_e(1e3*e,2)}));return[sm(Wi(i.heads)),...n?[s]:[]]}function sR(i,t){const e=Ja().loopSaid,n=Math.hypot(...i.poles[0]);if(n>1+Id){const m=Ud(t*Math.log(2)/Math.log(n),2);return{verdict:e.unstable,level:"bad",title:is(e.doubles,{time:m}),lead:[],numbers:[]}}if(n>1-Id)return{verdict:e.free,level:"warn",title:e.unheld,lead:[],numbers:[]};const s=e.both,o=i.gain_high??1/0,a=i.delay===null?1/0:Math.floor(1e4*i.delay)/1e4,r=[[(i.delay??1/0)/(VT*t),a<1/0?"":e.anyDelay],[(o-1)/pd,is(e.stronger,{change:kd(o-1),place:s})],[(1-i.gain_low)/pd,is(e.weaker,{change:kd(1-i.gain_low),place:s})]],[l,c]=r.reduce((m,f)=>f[0]<m[0]?f:m),h=String(Math.ceil(100*i.gain_low)),u=o<nR?is(e.range,{low:h,high:String(Math.floor(100*o))}):is(e.atLeast,{low:h}),d=i.phase===null?1/0:180*i.phase/Math.PI,p=o>=WT&&i.gain_low<=GT&&d>=$T&&(i.delay??1/0)>=t,[_,g]=l<1?[e.thin,"warn"]:p?[e.usual,"good"]:[e.small,"warn"];return{verdict:_,level:g,title:is(e.holds,{controller:"u = −K x",robot:C.setup.robot}),lead:c?[c]:[],numbers:[[Ud(a,3),is(e.delay,{place:s})],[`${u} %`,e.strength],[d<1/0?`${_e(d,2)}°`:"∞",e.phase]]}}function Ud(i,t){return i<.1?`${_e(1e3*i,t)} ms`:`${_e(i,t)} s`}function kd(i){return`${_e(100*i,2)} %`}const Ze=globalThis.uprightExport??null,ka=["nonlinear","linear"],ya="off",oR=200,rR=.02,Fd=.3,aR=3,lR=1.5,cR=60,Od=.02,hR=2;function am({facts:i}){const t=Object.entries(i.robots).map(([n,{controllers:s,laden:o}])=>[n,{controllers:[...Object.keys(s),ya],load:o?.look??null}]),e=Vi.robot in i.robots?Vi.robot:i.catalogue.robots[0].name;return{usual:{...Vi,robot:e,bodies:[...ka]},robots:Object.fromEntries(t),kits:[],parameters:[],bodies:ka,keys:["gains","slope","noise","delay","seed","payload","payload_height","bodies"]}}class uR{loop;offset;constructor(t,e,n,s,o,a){this.offset=[0,0,o[2],0,o[4],0];const r=[o[0],o[1],0,o[3],0,o[5]];this.loop=new tR({motion:e,period:t.period,gravity:t.gravity,kit:n},s,r,a)}state(){const t=Array.from(this.loop.x,(e,n)=>e+this.offset[n]);return this.loop.fallen&&([t[0],t[1],t[3],t[5]]=[Math.sign(t[0])*lR,0,0,0]),t}row(){return[...this.state(),...this.loop.applied,this.loop.fallen?1:0]}shifted(t){return[t[2]+this.offset[2],t[4]+this.offset[4]]}estimate(t){const{before:e,y:n}=this.loop,[s,o]=[t.S??[],t.Sy??[]],a=(r,l)=>r.reduce((c,h,u)=>c+h*l[u],0);return s.map((r,l)=>a(r,e)+a(o[l],n)+this.offset[l])}}class dR{constructor(t){this.data=t,this.setup=am(t).usual,C.send=e=>this.take(e),C.hear(t.facts.welcome),C.hear(t.facts.catalogue),this.changeTo(this.setup),window.setInterval(()=>this.tick(),16)}setup;lanes=[];periods=0;owed=0;paused=!1;speed=1;back=0;n=0;wall=performance.now();target=new Float64Array(6);steer={speed:0,rate:0};hand={force:0,start:-1,duration:1/0,height:0};active=[];pulled={until:-1,force:0};acting=new Float64Array(3);pulling=0;kept=[];score=new Bh;recorder=new gA;run={rows:0,peak:0,travel:0,from:0};thinking=0;spent=0;get facts(){const t=this.data.facts.robots[this.setup.robot];return this.setup.payload&&t.laden?{...t,...t.laden}:t}get controller(){return this.facts.controllers[this.setup.controller]??null}get t(){return this.periods*this.facts.every}take(t){switch(C.note(t,this.t),t.kind){case"Change":this.changeTo(t.setup);break;case"Drag":t.force&&!this.hand.force&&this.score.push(),this.hand={...this.hand,force:t.force,height:t.height};break;case"Strike":this.strike(t.what,t.size);break;case"Steer":this.steer={speed:t.speed,rate:t.rate};break;case"Play":[this.paused,this.speed,this.back]=[t.paused,t.speed,t.paused?this.back:0];break;case"Step":this.stepped(t.periods);break;case"Scrub":[this.paused,this.back]=[!0,t.back];break;case"StandUp":this.stand(t.pitch);break;case"Save":t.what==="csv"?this.keepTraces():this.handIn(t.name);break;default:return}(t.kind==="Drag"||t.kind==="Strike"||t.kind==="Steer")&&this.recorder.note(t,this.t),this.show()}changeTo(t){const e=this.data.facts.robots,n=Object.hasOwn(e,t.robot)?t.robot:this.setup.robot,s=e[n].controllers,a=Object.hasOwn(s,t.controller)||t.controller===ya?t.controller:Object.keys(s)[0],r=t.gains.length===6?t.gains:s.gains?.gains??[],l=ka.filter((M,S)=>S===0||t.bodies.includes(M)),c=t.payload?e[n].laden?.look:void 0,{payload:h,payload_height:u}=c??Vi,[d,p]=[this.setup,this.lanes.length>0&&n===this.setup.robot];this.setup={...t,robot:n,controller:a,gains:r,bodies:l,payload:h,payload_height:u},this.recorder.stop();const _=p&&l.length===this.lanes.length,g=_&&a===d.controller&&t.noise===d.noise&&t.delay===d.delay&&h===d.payload,m=p&&!this.lanes[0].loop.fallen?this.lanes[0].state():[0,0,0,0,0,0],f=l.map((M,S)=>_&&!this.lanes[S].loop.fallen?this.lanes[S].state():m);if(JSON.stringify({...d,slope:0})!==JSON.stringify({...this.setup,slope:0})&&this.score.exchanged(),g)for(const M of this.lanes)M.loop.control.gains=r;else this.build(f);_||(this.kept=[]),p||this.traced(),this.said(!p||h!==d.payload)}said(t){const{facts:e,controller:n,setup:s}=this,o={delay:this.delay(),dead_zone:e.kit?.dead_zone??0,voltage:e.kit?.voltage??-1},a={kind:"Changed",setup:s,look:e.look,bodies:s.bodies,period:e.every,controller:n?.kind??ya,truth:n?.truth??!1,kit:o,busy:!1};if(C.hear(a),t&&C.hear(e.equations),C.analysed=null,window.clearTimeout(this.thinking),C.hear(Kp),!n)return;const{plant:r}=n;n.analysed?C.hear({...n.analysed,L:[nm(e.every),...n.analysed.L]}):r&&(this.thinking=window.setTimeout(()=>{const l=PA(r,this.data.laws[s.robot][s.controller],s.gains),{stable:c,poles:h,L:u}=l;C.hear({kind:"Analysed",stable:c,heads:RT(()=>sR(l,r.period)),gain:[s.gains],poles:h,L:u})},oR))}traced(){C.traces.reset(this.setup.bodies.length),this.kept=[],this.periods=0}delay(){return this.setup.delay<0?this.facts.delay_own:this.setup.delay}kit(){const{kit:t,period:e}=this.facts;if(!t)return null;const n=this.setup.noise,s=t.sensors.map(o=>({...o,quantum:o.quantum*n,noise:o.noise*n,bias:o.bias*n}));return{...t,sensors:s,delay:Math.round(this.delay()/e)}}build(t){const{facts:e,setup:n,controller:s}=this,o=s?this.data.laws[n.robot][n.controller]:null,a=s?.stride??Math.round(e.every/e.period),r={law:o,reads:s?.reads??[],stride:a,gains:n.gains},l=n.bodies.map(h=>h===ka[0]?this.data[n.payload?"laden":"motions"][n.robot]:eR(e.linear)),c=this.kit();this.lanes=l.map((h,u)=>new uR(e,h,c,{...r},t[u]??[0,0,0,0,0,0],n.seed)),this.target.fill(0),[this.owed,this.back]=[0,0],this.run={rows:0,peak:0,travel:0,from:this.lanes[0].loop.x[2]}}stand(t){[this.active,this.pulled]=[[],{until:-1,force:0}],this.hand={...this.hand,force:0},this.score=this.score.anew(t),this.build(this.lanes.map(()=>[t,0,0,0,0,0])),this.recorder.begin(this.t,t,this.steer),C.hear({kind:"Acted",t:this.t})}result(){const{rows:t,peak:e,travel:n}=this.run,{fallen:s}=this.lanes[0].loop;return{fell:s,seconds:Co((t-1)*this.facts.every),peak:Co(e),travel:Co(n*this.facts.look.wheel_radius),best:Co(this.score.run)}}handIn(t){const{facts:e}=this,n={...this.setup,...e.setup,gains:this.setup.controller==="gains"?this.setup.gains:[]},s=e.setup&&this.recorder.handIn(t,n,e.period,this.t,this.result());if(!s)return C.hear({kind:"Notice",level:"error",parts:{},key:e.setup?"noRun":"noReplay",job:""});const o=URL.createObjectURL(new Blob([s],{type:"application/json"}));C.hear({kind:"Made",what:"json",name:"hand-in.json",url:o})}keepTraces(){const{t,x:e,volts:n}=C.traces,s=this.facts.look.command_unit,o=qs.map((h,u)=>[`truth/${h}`,qT[u],e[0][u]]);o.push(["applied/left",s,n[0]],["applied/right",s,n[1]]);const a={robot:{name:this.setup.robot},controller:{kind:this.controller?.kind??ya},body:{kind:"nonlinear model, in a page",real:!1}},r=JSON.stringify({units:Object.fromEntries(o.map(([h,u])=>[h,u])),origin:a}),l=t.map((h,u)=>[h,...o.map(([,,d])=>d[u])].join()),c=[`# upright-log: ${r}`,["t",...o.map(([h])=>h)].join(),...l].join(`
`)+`
`;C.hear({kind:"Made",what:"csv",name:"run.csv",url:URL.createObjectURL(new Blob([c],{type:"text/csv"}))})}strike(t,e){const{look:n,equations:s,every:o}=this.facts,a=this.t;if(this.score.push(),C.hear({kind:"Acted",t:a}),t==="pull_left"||t==="pull_right")this.pulled={until:a+Fd,force:t==="pull_left"?e:-e},this.active.push({force:e,start:a,duration:Fd,height:0});else if(t==="impulse"){const r=Math.max(Math.round(rR/o),1)*o;this.active.push({force:e/r,start:a,duration:r,height:n.com_height})}else{const r=-s.weight*Math.sin(e)/(n.com_height*Math.cos(e)+n.wheel_radius);this.active.push({force:r,start:a,duration:aR,height:n.com_height})}}tick(){const t=performance.now(),e=Math.min((t-this.wall)/1e3,hR);this.wall=t,!this.paused&&(this.advance(e*this.speed),this.spent+=performance.now()-t,this.show())}advance(t){const{every:e}=this.facts;for(this.owed+=t;this.owed>=e*(1-1e-9);)this.owed-=e,this.period()}stepped(t){[this.paused,this.back]=[!0,0];for(let e=0;e<t;e+=1)this.period()}period(){const{every:t,look:e,pull:n}=this.facts,{t:s}=this;this.active=this.active.filter(_=>s<_.start+_.duration-1e-9);const o=this.hand.force?[...this.active,this.hand]:this.active,a=this.acting;KA(o,s,this.setup.slope,a);const r=s<this.pulled.until-1e-9?this.pulled.force:0;this.pulling=r;const l=this.steer.speed/e.wheel_radius;this.target.set([0,0,this.target[2]+l*t,l,this.target[4]+this.steer.rate*t,this.steer.rate]),this.noted();for(const{loop:_}of this.lanes)_.twist=r*n,_.fallen||_.step(this.target,(g,m)=>m.set(a));this.periods+=1;const{x:c,applied:h,fallen:u}=this.lanes[0].loop,d=this.score.watch(t,r?0:a[0],c[0],c[1],h,u);d&&C.hear(d);const p=this.kept.at(-1);(!p||this.t-p.t>=Od-1e-9)&&this.kept.push(this.snapshot()),this.kept.length>cR/Od+200&&this.kept.splice(0,200)}noted(){const{x:t,fallen:e}=this.lanes[0].loop;e||(this.run.rows+=1,this.run.peak=Math.max(this.run.peak,Math.abs(t[0])),this.run.travel=Math.max(this.run.travel,Math.abs(t[2]-this.run.from)))}snapshot(){const t=this.lanes[0],e=this.facts.look.limit??1/0,n=(t.loop.sent[0]**2>=e**2?1:0)+(t.loop.sent[1]**2>=e**2?2:0);return this.n+=1,{kind:"Snapshot",n:this.n,t:this.t,x:this.lanes.map(s=>s.row()),e:this.controller?t.estimate(this.controller):[],f:[...this.acting,this.pulling],r:t.shifted(this.target),s:n,paused:!1,back:0}}show(){const t=this.snapshot();if(this.back){const s=this.kept.findLast(o=>o.t<=t.t-this.back)??this.kept[0]??t;return this.n+=1,C.hear({...s,n:this.n,paused:!0,back:this.back})}const e=C.traces.t.at(-1)??-1/0,n=this.kept.findLastIndex(s=>s.t<=e);for(const s of this.kept.slice(n+1))s.t<t.t&&C.traces.add(s);C.hear({...t,paused:this.paused})}}const fR=1e3,pR=["nonlinear","linear"],mR=["twin","nonlinear","linear","published"];let Bd=0;function wc(){if(Ze)return am(Ze);const{robots:i,families:t,kits:e,units:n}=C.catalogue??{robots:[],families:[],kits:[],units:{}},s=t.map(a=>a.name),o=C.role==="alone"?Vi.bodies:pR;return{usual:{...Vi,bodies:o},robots:Object.fromEntries(i.map(({name:a,kit:r})=>[a,{kit:r,controllers:s}])),kits:e,bodies:mR,parameters:Object.keys(n),keys:Object.keys(Vi)}}function zh(){return location.href.split("#")[0]+FT(C.setup,C.last.push,wc())}function gR(){if(!Na(location.hash))return;const{setup:i,push:t,robot:e,controller:n,left:s}=OT(location.hash,wc()),{robots:o}=wc();C.change(i);const a=()=>[e&&U("noSuchRobot",{name:e,shown:i.robot,all:Object.keys(o).join(", ")}),n&&U("noSuchController",{name:n,shown:i.controller,all:o[i.robot].controllers.join(", ")}),s.length&&U("leftOut",{parts:s.join(", ")})].filter(Boolean).join(" ");a()&&C.say(a,"error"),C.last.name(t),window.clearTimeout(Bd);const r=()=>{Bd=C.settled?window.setTimeout(()=>(t||C.falls)&&C.send(kT(t??["tilt",tl])),fR):window.setTimeout(r,100)};r()}const _R=Uh(60,i=>C.change(i)),vR=8;class xR{constructor(t){this.session=t}root=k("div",{className:"panel-body"});sliders=[];title=k("p",{className:"note"});ghost=null;load=null;build(){const t=(C.catalogue?.robots??[]).map(r=>[r.name,r.name]),e=fs(U("preset"),t,C.setup.robot,r=>C.change({robot:r,gains:[],delay:-1}),"robot"),n=(r,l,c,h,u,d)=>[r,Kn(l,{low:c,high:h,step:u,show:d,key:r},p=>_R({[r]:p}))];this.sliders=[n("slope",U("slope"),-.2,.2,.005,Ih),n("noise",U("noise"),0,10,.1,r=>`× ${_e(r,2)}`),n("delay",U("delay"),0,.05,.001,r=>`${_e(r*1e3,2)} ms`)];const s=k("input",{type:"checkbox",id:"ghost","data-key":"ghost",onchange:()=>C.change({bodies:s.checked?["nonlinear","linear"]:["nonlinear"]})});this.ghost=s;const o=k("input",{type:"checkbox",id:"load","data-key":"load",onchange:()=>C.change({payload:o.checked?1:0})});this.load=o;const a=te(U("ownKit"),()=>C.change({slope:0,noise:1,delay:-1,payload:0}),{className:"quiet","data-key":"own-kit"});Xt(this.root,k("div",{className:"column"},e,this.title,k("label",{for:"ghost",className:"check"},s,U("ghost")),this.carried),k("div",{className:"column wide"},k("div",{className:"sliders"},...this.sliders.map(([,r])=>r.root),k("p",{className:"note"},U("stays")),a))),this.update()}carried=k("label",{for:"load",className:"check"});update(){const t=this.root.querySelector("[data-key=robot]");t&&document.activeElement!==t&&(t.value=C.setup.robot),this.ghost&&(this.ghost.checked=C.setup.bodies.length>1);const e=this.session()?.facts,n=e?.laden?.look;Xt(this.carried,...n&&this.load?[this.load,U("carries",{mass:_e(n.payload*1e3,3),height:_e(n.payload_height*100,3)})]:[]),this.load&&(this.load.checked=C.setup.payload>0),this.title.textContent=e?`${Wi(e.title)} (${U("kit")}: ${e.kit_name})`:"";const s=this.sliders.find(([o])=>o==="delay")?.[1].root.querySelector("input");s&&(s.max=String(Math.max(.05,2*(e?.delay_own??0))));for(const[o,a]of this.sliders)a.set(o==="delay"?C.changed?.kit.delay??0:C.setup[o])}}function zd(i){const t=i.split(" ").flatMap((s,o)=>[o?" ":"",k("span",{className:"token"},s)]),e=k("code",{tabIndex:0},...t),n=te(U("copy"),()=>{getSelection()?.selectAllChildren(e),navigator.clipboard?.writeText(i).then(()=>n.textContent=U("copied"),()=>{})},{"aria-label":`${U("copy")}: ${i}`,"data-key":`copy-${i.replace(/\W+/g,"-")}`});return k("div",{className:"shell"},e,n)}class bR{root=k("div",{className:"panel-body"});shown="";build(){const{robot:t,controller:e}=C.setup;this.shown=JSON.stringify([t,e]);const n=String(parseFloat((vR*(C.changed?.look.wheel_radius??.04)).toPrecision(2))),s={robot:t,controller:e,speed:n},o=["off","gains"].includes(e),a=t==="nxtway-gs"?"--drive":"upright example",l=Ja().python.filter(([,c])=>!c.includes(a)).map(([c,h])=>[c,o?h.replace(" -c {controller}",""):h]).filter(([,c])=>!(o&&c.includes("{controller}"))).flatMap(([c,h])=>[k("dt",{},c),k("dd",{},zd(h.replace(/\{(\w+)\}/g,(u,d)=>s[d]??"")))]);Xt(this.root,k("div",{className:"column full"},k("p",{className:"note"},U("pythonNote")),zd(U("install")),k("dl",{className:"commands"},...l)))}update(){this.shown!==JSON.stringify([C.setup.robot,C.setup.controller])&&this.build()}}function yR(i){return te(U("lookAtThis"),()=>{const[t,{kept:e}]=[zh(),C.last],n=()=>window.prompt(U("lookAtThis"),t),s=()=>`${U(location.protocol==="file:"?"lookHere":"lookCopied")} ${U(e)}`;navigator.clipboard?navigator.clipboard.writeText(t).then(()=>i(s),n):n()},{"data-key":"look",title:U("lookTip")})}class MR{constructor(t,e){this.credentials=t,this.say=e,C.send=n=>this.send(n),this.open()}socket=null;wait=250;closed=!1;first=!0;send(t){C.note(t,C.snapshot?.t??0),this.socket?.readyState===WebSocket.OPEN&&this.socket.send(JSON.stringify(t))}open(){this.say(this.first?"connecting":"lost");const t=new URL("ws",document.baseURI);t.protocol=t.protocol.replace("http","ws"),t.hash="";const e=new WebSocket(t);this.socket=e,e.onopen=()=>this.greet(),e.onmessage=n=>this.hear(JSON.parse(n.data)),e.onclose=()=>this.lost()}greet(){const t=this.first&&Na(location.hash);this.send({kind:"Hello",version:HT,session:t?"":ki.getItem("session")??"",token:this.credentials.token,name:this.credentials.name,setup:C.changed?C.setup:null})}hear(t){t.kind==="Snapshot"&&this.send({kind:"Ack",n:t.n}),t.kind==="Welcome"&&(ki.setItem("session",t.session),this.wait=250,this.first=!1,this.say("connected")),t.kind==="Refused"&&(this.closed=!0,this.say("refused",()=>Sr(t.parts))),C.hear(t)}lost(){this.closed||(this.say("lost"),window.setTimeout(()=>this.open(),this.wait),this.wait=Math.min(this.wait*1.6,3e3))}}const SR=1e3,wR=500;class lm{constructor(t){this.job=t;const e=t.startsWith("keep "),n=hn(()=>e?U("writing"):Qe(t));n.id=$s("job"),this.done.setAttribute("aria-labelledby",n.id);const s=hn(()=>e?"":Qe(`doing_${t}`)),o={kind:"Cancel",job:t};this.root=k("div",{className:"bar"},k("b",{},n),k("button",{type:"button",onclick:()=>C.send(o),"data-key":`stop-${t}`},hn(()=>U("stop"))),this.done,this.words,k("p",{className:"note"},s));const a=window.setInterval(()=>this.share<1?this.say():window.clearInterval(a),wR);this.say()}root;done=k("progress",{max:1});words=k("span",{className:"note"});first={share:0,at:0};left=NaN;share=0;began=performance.now();at=this.began;to(t){const e=performance.now();t>0&&!this.first.share&&(this.first={share:t,at:e}),t>this.first.share&&e>this.first.at+SR&&(this.left=(1-t)*(e-this.first.at)/(t-this.first.share)),[this.share,this.at]=[t,e],this.done.value=t,this.say()}say(){const[t,e]=[performance.now(),o=>String(Math.ceil(o/1e3))],n=this.left-(t-this.at),s=Number.isNaN(n)?U("soFar",{seconds:e(t-this.began)}):n>0?U("stillTakes",{seconds:e(n)}):U("overdue",{seconds:e(t-this.began)});this.words.textContent=this.share?`${(100*this.share).toFixed(0)} % · ${s}`:U("oneAtATime")}}const ER=["127.0.0.1","localhost","[::1]"],TR=Uh(120,i=>C.change(i));let Cl={};function xi(i){Cl={...Cl,...i},C.expect(i),TR(Cl)}class Ar{root=k("div",{className:"panel-body"});update(){}}class AR extends Ar{noCertificate=k("p",{className:"note column full"});weights=k("div",{className:"sliders"});numbers=k("div",{className:"numbers"});gain=k("div",{});light=k("div",{className:"light",role:"status"});reasons=k("div",{});sliders=[];shape="";bar=null;working=k("div",{});reported=null;certified=k("div",{className:"column full certified","aria-live":"polite"});page=new om;build(){this.shape="",this.reported=null,Xt(this.certified);const t=(C.catalogue?.families??[]).map(s=>[s.name,Qe(s.name)]),e=fs(U("family"),t,C.setup.controller,s=>{C.change({controller:s,gains:s==="gains"?this.present():C.setup.gains}),s==="off"&&C.send({kind:"StandUp",pitch:tl})},"controller"),n=te(U("fullCertificate"),()=>C.send({kind:"Start",job:"certify",file:""}),{"data-key":"certify"});Xt(this.root,k("div",{className:"column"},e,this.weights),k("div",{className:"column full"},this.gain),k("div",{className:"column full"},this.numbers),Ze?this.noCertificate:k("div",{className:"column full"},this.light,n,this.working,this.reasons),this.certified),this.update()}certify(){this.update(),this.certified.scrollIntoView({block:"nearest"})}certifying(t){const e=this.root.querySelector("[data-key=certify]");if(e?.toggleAttribute("aria-busy",t<1),e&&(e.textContent=U("fullCertificate")+(t<1?`: ${(100*t).toFixed(0)} %`:"")),t>=1&&!this.bar)return;const n=!this.bar;this.bar??=new lm("certify"),this.bar.to(t),Xt(this.working,t<1?this.bar.root:null),n&&this.working.scrollIntoView({block:"nearest"}),t>=1&&(this.bar=null)}present(){return C.analysed?.gain[0]?.slice(0,6)??[]}update(){const t=this.root.querySelector("[data-key=controller]");t&&document.activeElement!==t&&(t.value=C.setup.controller);const e=`${C.setup.controller} ${C.changed?.look.command_unit} ${C.setup.controller==="gains"?this.byHand().length:""}`;e!==this.shape&&this.shapeWeights(e),this.sliders.forEach((s,o)=>s.set(C.setup.controller==="gains"?this.byHand()[o]??0:this.sizes()[o]));const n=C.setup.controller!=="off";Sl(this.gain,n&&!C.analysed,...this.gains()),Sl(this.numbers,n&&!C.analysed,...this.analysis()),Xt(this.light,...RR()),Sl(this.reasons,n&&!C.lit?.heads.en,CR()),this.noCertificate.textContent=U(["gains","off"].includes(C.setup.controller)?"noCertificateByHand":"noCertificateHere"),this.reported!==C.certified&&(this.reported=C.certified,Xt(this.certified,...this.reported?[k("p",{},U("certified")),this.page.show(this.reported)]:[]))}byHand(){return C.setup.gains.length?C.setup.gains:this.present()}sizes(){const t=C.changed?.look.command_unit??"V",e=[...C.catalogue?.largest??[],C.catalogue?.command[t]??1];return C.setup.largest.length===e.length?C.setup.largest:e}shapeWeights(t){this.shape=t;const e=C.catalogue?.families.find(n=>n.name===C.setup.controller);if(this.sliders=[],C.setup.controller==="gains"){const n=this.byHand(),s=Math.max(...n.map(Math.abs),.1),o=C.changed?.look.command_unit??"V",a=l=>`${o}${l%2?" s":""}/rad`,r=l=>Math.max(4*Math.abs(n[l]??0),s/4);this.sliders=Vs.map((l,c)=>Kn(`${l} ${Qe(qs[c])} → u`,{low:-r(c),high:r(c),step:r(c)/500,show:h=>`${_e(h,4)} ${a(c)}`,typed:a(c),key:`gain-${c}`},h=>{const u=[...this.byHand().length?this.byHand():[0,0,0,0,0,0]];u[c]=h,xi({gains:u})})),Xt(this.weights,...this.sliders.map(l=>l.root))}else if(e?.weights&&!Ze){const n=[...C.catalogue?.largest??[],C.catalogue?.command[C.changed?.look.command_unit??"V"]??1];this.sliders=n.map((o,a)=>this.weight(o,a));const s=te(U("ownWeights"),()=>C.change({largest:[]}),{className:"quiet","data-key":"own-weights"});Xt(this.weights,k("p",{className:"note"},U("weights")),...this.sliders.map(o=>o.root),s)}else Xt(this.weights,C.setup.controller==="off"?null:k("p",{className:"note"},U(e?.weights?"fixedWeights":"noWeights")))}weight(t,e){const n=e<6?Yp[e]:` ${C.changed?.look.command_unit??"V"}`,s=e<6?Qa:1,o=e<6?`${Vs[e]} ${Qe(qs[e])}`:U("command");return Kn(o,{low:t/10,high:t*10,log:!0,show:a=>`${_e(s*a,2)}${n}`,key:`weight-${e}`},a=>{const r=[...this.sizes()];r[e]=a,xi({largest:r})})}gains(){const t=C.analysed?.gain??[];return!t.length||["gains","off"].includes(C.setup.controller)?[]:[k("h4",{},U("gain")),qp(Vs,[t[0].map(e=>_e(e,3))],"gains"),k("p",{className:"note"},U("gainNote",{unit:C.changed?.look.command_unit??"V"}))]}analysis(){const t=C.analysed;return C.setup.controller==="off"?[k("p",{className:"note"},U("noLoop"))]:t?rm(t):[k("p",{className:"note"},U("designing")+(C.setup.controller==="robust"?" "+U("robustTakes"):""))]}}function cm(){const i=C.lit?.light??"none";return C.setup.controller==="off"||i==="none"&&C.analysed!==null&&iR(C.analysed)?"red":i}function Ec(i=!1){const{setup:t,lit:e,trying:n,jobs:s}=C;if(t.controller==="off")return U("unlitOff");if(!e?.heads.en)return n?i?`${(100*n.fraction).toFixed(0)} % …`:U("tried",{n:Math.round(n.fraction*n.runs),all:n.runs}):U(s.size?"queued":"none");if(e.light==="none")return U("noCertificate");const o=i?U(e.light):Wi(e.heads).verdict;return t.payload>0?U(t.slope&&!i?"litBoth":"litPayload",{light:o}):t.slope?U("litSlope",{light:o}):o}function RR(){const i=k("span",{className:`lamp ${cm()}`,"aria-hidden":"true"});return[k("h4",{},U("certificate")),k("p",{className:"lit"},i,k("b",{},Ec()))]}function CR(){return C.setup.controller==="off"||C.certified?null:C.lit?.heads.en?sm({...Wi(C.lit.heads),verdict:""}):C.jobs.size?null:k("p",{className:"note"},U("lightNote"))}class PR extends Ar{sliders=[];table=k("div",{className:"parameters"});fields=new Map;shown="";opened=!1;title=k("p",{className:"note"});build(){this.shown="",this.fields.clear();const t=(C.catalogue?.robots??[]).map(s=>[s.name,s.name]);t.some(([s])=>s===C.setup.robot)||t.push([C.setup.robot,C.setup.robot]);const e=fs(U("preset"),t,C.setup.robot,s=>this.choose(s),"robot");this.sliders=[["payload",Kn(U("payload"),{low:0,high:this.weight(),step:.005,show:s=>`${_e(s*1e3,3)} g`,key:"payload"},s=>xi({payload:s}))],["payload_height",Kn(U("payloadHeight"),{low:0,high:.5,step:.005,show:s=>`${_e(s*100,3)} cm`,key:"payload_height"},s=>xi({payload_height:s}))],["slope",Kn(U("slope"),{low:-.2,high:.2,step:.005,show:Ih,key:"slope"},s=>xi({slope:s}))],["grip",Kn(U("grip"),{low:.02,high:10,log:!0,show:s=>_e(s,2),key:"grip"},s=>xi({grip:s}))]];const n=k("details",{open:this.opened,ontoggle:()=>this.opened=n.open},k("summary",{},U("numbers")),k("p",{className:"note"},U("numbersNote")),this.table);Xt(this.root,k("div",{className:"column"},e,this.title,hm(U("openRobot"),".toml","robot")),k("div",{className:"column"},k("div",{className:"sliders"},...this.sliders.map(([,s])=>s.root))),k("div",{className:"column"},this.bodies()),k("div",{className:"column full"},n)),this.update()}weight(){return Math.max(.3,(C.changed?.look.weight??6)/9.81*.6)}choose(t){const e=C.catalogue?.robots.find(n=>n.name===t);e&&C.change({robot:t,numbers:{},drive:"",kit:e.kit,largest:[],gains:[],payload:0,delay:-1,voltage:-1,dead_zone:-1})}bodies(){const t=["twin","nonlinear","linear","published",...C.changed?.bodies.includes("calibrated")?["calibrated"]:[]],e=t.map(n=>{const s=$s("body"),o=k("input",{type:"checkbox",id:s,checked:C.setup.bodies.includes(n),"data-key":`body-${n}`,onchange:()=>{const a=t.filter(r=>r===n?o.checked:C.setup.bodies.includes(r));a.length?C.change({bodies:a}):o.checked=!0}});return k("label",{for:s,className:"check"},o,Qp(n))});return k("fieldset",{},k("legend",{},U("bodies")),...e)}update(){for(const[s,o]of this.sliders)o.set(C.setup[s]);const t=C.catalogue?.robots.find(s=>s.name===C.setup.robot);this.title.textContent=t?Wi(t.title):"";const e=JSON.stringify([C.setup.robot,C.setup.numbers,C.changed?.bodies]);if(e===this.shown)return;const n=this.shown!=="";this.shown=e,n&&!this.root.contains(document.activeElement)&&this.build(),this.parameters()}parameters(){const e={...C.catalogue?.robots.find(s=>s.name===C.setup.robot)?.numbers??{},...C.setup.numbers};if(Object.keys(e).join()===[...this.fields.keys()].join())return this.fields.forEach((s,o)=>s.set(e[o]));this.fields.clear();const n=Object.keys(e).map(s=>{const o=$s("number"),a=Wp(l=>C.change({numbers:{...C.setup.numbers,[s]:l}}),{id:o,"data-key":`number-${s}`});this.fields.set(s,a);const r=C.catalogue?.symbols[s]??"";return k("div",{className:"parameter"},k("label",{for:o},`${Wi(C.catalogue?.names??{})?.[s]??s} ${r}`),a.root,k("span",{},(C.catalogue?.units[s]??"").replace(/^1$/,"")))});this.fields.forEach((s,o)=>s.set(e[o])),Xt(this.table,...n,te(U("ownNumbers"),()=>C.change({numbers:{},drive:""}),{className:"quiet","data-key":"own-numbers"}))}}class LR extends Ar{sliders=[];anew=k("p",{className:"note"});build(){const t=(C.catalogue?.kits??[]).map(o=>[o,o==="ideal"?U("ideal"):o]),e=fs(U("kit"),t,C.setup.kit,o=>C.change({kit:o,delay:-1,voltage:-1,dead_zone:-1,noise:1}),"kit"),n=C.changed?.look.command_unit??"V";this.sliders=[["noise",Kn(U("noise"),{low:0,high:10,step:.1,show:o=>`× ${_e(o,2)}`,key:"noise"},o=>xi({noise:o}))],["delay",Kn(U("delay"),{low:0,high:.04,step:.002,show:o=>`${_e(o*1e3,2)} ms`,key:"delay"},o=>xi({delay:o}))],["voltage",Kn(U("voltage"),{low:1,high:14,step:.1,show:o=>o>0?`${_e(o,3)} V`:U("unlimited"),key:"voltage"},o=>xi({voltage:o}))],["dead_zone",Kn(U("deadZone"),{low:0,high:n==="V"?2:.1,show:o=>`${_e(o,2)} ${n}`,key:"dead_zone"},o=>xi({dead_zone:o}))]];const s=te(U("ownKit"),()=>C.change({noise:1,delay:-1,voltage:-1,dead_zone:-1}),{className:"quiet","data-key":"own-kit"});Xt(this.root,k("div",{className:"column"},e,s),k("div",{className:"column wide"},k("div",{className:"sliders"},...this.sliders.map(([,o])=>o.root)),this.anew)),this.update()}update(){const t=C.changed?.kit??{};for(const[n,s]of this.sliders)s.set(n==="noise"?C.setup.noise:t[n]);this.anew.textContent=["gains","off"].includes(C.setup.controller)?"":U("redesigned");const e=this.root.querySelector("[data-key=kit]");e&&document.activeElement!==e&&(e.value=C.setup.kit)}}function wr(i,t=""){C.send({kind:"Save",what:i,name:t,language:Bo()})}function hm(i,t,e){const n=$s("file"),s=k("input",{type:"file",id:n,accept:t,className:"file","data-key":`open-${e}`,onchange:()=>{const o=s.files?.[0];s.value="",o&&NR(o,e)}});return k("div",{className:"upload"},s,k("label",{for:n,className:"button"},i))}let Us="",um=()=>{};async function NR(i,t){const e=`upload/${C.session}?what=${t}&name=${encodeURIComponent(i.name)}`;C.say(()=>U("uploaded",{name:i.name}));try{const n=await fetch(e,{method:"POST",body:i}),{name:s,error:o}=await n.json();o?C.say(()=>Sr(o),"error"):t==="log"&&(Us=s??"",um())}catch{C.say(()=>U("lost"),"error")}}const Tc="compare.html";class DR extends Ar{bars=k("div",{className:"bars"});result=k("div",{className:"result",role:"region","aria-live":"polite"});shares=new Map;running=new Map;source="";comparison=k("p",{className:"comparison",role:"status"});robot="";failed=k("p",{className:"failed",role:"alert"});load=0;page=new om(t=>this.next(t));constructor(){super(),um=()=>Hs(()=>this.build())}build(){const t=[["",U("thisRun")]];Us&&t.push([Us,Us.replace(/^in-/,"")]),Us&&(this.source=Us);const e=fs(U("source"),t,this.source,o=>this.source=o,"source"),n=k("div",{className:"row"},te(U("doctor"),()=>this.start("doctor"),{title:U("doctorTip"),"data-key":"doctor"}),te(U("calibrate"),()=>this.start("calibrate"),{title:U("calibrateTip"),"data-key":"calibrate"}),te(U("compare"),()=>this.compare(),{title:U("compareTip"),"data-key":"compare"})),s=".csv,.txt,.log,.tsv,.dat,.json,.mat,.parquet,.mcap";this.changed();for(const o of[this.comparison,this.failed])La(o);Xt(this.root,k("div",{className:"column"},e,hm(U("openLog"),s,"log"),n,this.failed,this.comparison,k("p",{className:"note"},U("calibrateNote")),this.bars),k("div",{className:"column wide"},this.result)),this.found()}start(t){Xt(this.failed),this.load=this.source?0:C.setup.payload,C.send({kind:"Start",job:t,file:this.source})}fail(t,e){this.robot=C.setup.robot,Xt(this.failed,hn(t),e==="doctor"&&te(U("doctor"),()=>this.start("doctor"),{"data-key":"next-doctor"})),this.failed.scrollIntoView({block:"nearest"})}changed(){if(this.robot!==C.setup.robot)for(const t of[this.comparison,this.failed])Xt(t)}compare(){this.robot=C.setup.robot,Xt(this.failed),wr("compare",this.source);const t=[...this.shares.keys()].some(e=>e!=="design")?"compareWaits":"comparing";Xt(this.comparison,hn(()=>U(t)))}compared(t){this.robot=C.setup.robot;const e=k("a",{href:t,target:"_blank",rel:"noopener","data-key":"open-comparison"},hn(()=>U("open"))),n=k("a",{href:t,download:Tc,"data-key":"save-comparison"},hn(()=>U("saveAs",{name:Tc})));Xt(this.comparison,hn(()=>U("compared"))," ",e," · ",n)}progress(t,e){if(t==="keep compare"){e>=1&&!this.comparison.querySelector("a")&&Xt(this.comparison);return}if(e>=1?this.shares.delete(t):this.shares.set(t,e),t==="design")return;const n=this.running.get(t)??new lm(t);n.to(e),e>=1?n.root.remove():this.running.has(t)||this.bars.append(n.root),e>=1?this.running.delete(t):this.running.set(t,n)}next(t){const e=[U("calibrate"),()=>this.start("calibrate")];return{calibrate:t==="calibrate"?[U("robotFile"),()=>wr("robot")]:e,...t==="doctor"?{}:{doctor:[U("doctor"),()=>this.start("doctor")]}}}found(){const t=C.found;if(!t)return;const e=t.job==="calibrate"&&this.load>0;Xt(this.result,e&&k("p",{className:"verdict bad"},k("b",{},U("calibratedLaden",{mass:_e(this.load*1e3,3)}))),this.page.show(t))}}class IR extends Ar{constructor(t){super(),this.picture=t}files=new Map;saved=k("p",{className:"saved"});linked=k("div",{});links=k("div",{className:"links",role:"status"},this.linked,this.saved);buildExported(){La(this.links);const t=te(U("csv"),()=>wr("csv"),{"data-key":"keep-csv"});Xt(this.root,k("div",{className:"column wide"},k("p",{className:"note"},U("csvNote")),k("div",{className:"row"},t,this.pictureButton()),k("p",{className:"note"},U("keepLive")),k("p",{className:"note"},U("handInNote")),this.handIn(),this.links))}build(){La(this.links);const t=[[U("keepData"),[["csv",U("csv")],["parquet",U("parquet")]]],[U("keepPages"),[["report",U("report")],["replay",U("replay")]]],[U("keepFiles"),[["controller",U("controllerFile")],["robot",U("robotFile")]]]],e=([o,a])=>te(a,()=>wr(o),{"data-key":`keep-${o}`}),n=(o,...a)=>k("div",{},k("h4",{},o),k("div",{className:"row"},...a)),s=te(U("link"),()=>void this.copy(),{"data-key":"link"});Xt(this.root,k("div",{className:"column wide"},k("p",{className:"note"},U("keepNote")),...t.map(([o,a])=>n(o,...a.map(e))),n(U("keepShow"),this.pictureButton(),s),k("p",{className:"note"},U("handInNote")),this.handIn(),this.links))}handIn(){const t=$s("student"),e=k("input",{type:"text",id:t,maxLength:40,autocomplete:"name",value:ki.getItem("name")??"","data-key":"student"}),n=()=>{e.value.trim()?wr("handin",e.value.trim()):(e.focus(),C.say(()=>U("nameMissing")))};return k("div",{className:"row hand-in"},k("label",{for:t},U("yourName")),e,te(U("handIn"),n,{"data-key":"keep-handin"}))}pictureButton(){return te(U("picture"),()=>void this.photograph(),{"data-key":"picture"})}async photograph(){const t=await this.picture();t&&this.made(t.type.includes("svg")?"upright.svg":"upright.png",URL.createObjectURL(t))}async copy(){const[t,{kept:e}]=[zh(),C.last];history.replaceState(null,"",t),await navigator.clipboard?.writeText(t).catch(()=>{});const n=()=>`${U(ER.includes(location.hostname)?"linkHere":"linkCopied")} ${U(e)}`;C.say(n);const s=k("input",{readOnly:!0,value:t,"aria-label":U("link"),className:"address"});Xt(this.linked,k("p",{className:"note"},hn(n)),s),s.select()}made(t,e){const n=k("a",{href:e,download:t},t);this.files.set(t,n),Xt(this.saved,hn(()=>U("saved")),...[...this.files.values()].flatMap(s=>[" ",s])),n.click()}}class Hd{moments;at=0;paused=!1;speed=1;clock=performance.now();constructor(t){const e=t.filter(n=>n.kind==="Snapshot");this.moments=e.map(n=>({...n,t:n.t-e[0].t})),C.recorded=Math.max(this.length(),.02),C.send=n=>this.act(n);for(const n of t)n.kind!=="Snapshot"&&C.hear(n);window.setInterval(()=>this.tick(),20)}static inPage(){const t=document.getElementById("recording");return t?JSON.parse(t.textContent??"[]"):null}tick(){const t=performance.now();!this.paused&&this.moments.length&&(this.at+=(t-this.clock)/1e3*this.speed,this.at>this.length()&&this.rewind(),this.show()),this.clock=t}length(){return this.moments.at(-1)?.t??0}rewind(){this.at=0,C.traces.reset(this.moments[0].x.length)}show(){const t=this.at,e=C.traces.t.at(-1)??-1/0;t<e&&C.traces.until(t);const n=this.moments.filter(o=>o.t>e&&o.t<=t),s=n.at(-1)??this.moments.findLast(o=>o.t<=t);for(const o of n.slice(0,-1))C.traces.add(o);s&&C.hear({...s,paused:this.paused,back:0})}act(t){if(t.kind==="Play")this.paused=t.paused,this.speed=t.speed;else if(t.kind==="Scrub")this.at=Math.max(0,this.length()-t.back);else if(t.kind==="Step")this.paused=!0,this.at=Math.min(this.at+.02*t.periods,this.length());else if(t.kind==="StandUp")this.rewind();else return;this.show()}}/**
 * @license
 * Copyright 2010-2024 Three.js Authors
 * SPDX-License-Identifier: MIT
 */const Hh="170",UR=0,Vd=1,kR=2,dm=1,fm=2,Ui=3,ms=0,Pn=1,Fi=2,cs=0,No=1,Gd=2,Wd=3,$d=4,FR=5,ks=100,OR=101,BR=102,zR=103,HR=104,VR=200,GR=201,WR=202,$R=203,Ac=204,Rc=205,qR=206,XR=207,jR=208,YR=209,KR=210,ZR=211,JR=212,QR=213,tC=214,Cc=0,Pc=1,Lc=2,zo=3,Nc=4,Dc=5,Ic=6,Uc=7,pm=0,eC=1,nC=2,hs=0,iC=1,sC=2,oC=3,rC=4,aC=5,lC=6,cC=7,mm=300,Ho=301,Vo=302,kc=303,Fc=304,el=306,Fa=1e3,Os=1001,Oc=1002,ci=1003,hC=1004,Xr=1005,bi=1006,Pl=1007,Bs=1008,$i=1009,gm=1010,_m=1011,Tr=1012,Vh=1013,Xs=1014,Oi=1015,Rr=1016,Gh=1017,Wh=1018,Go=1020,vm=35902,xm=1021,bm=1022,li=1023,ym=1024,Mm=1025,Do=1026,Wo=1027,Sm=1028,$h=1029,wm=1030,qh=1031,Xh=1033,Ma=33776,Sa=33777,wa=33778,Ea=33779,Bc=35840,zc=35841,Hc=35842,Vc=35843,Gc=36196,Wc=37492,$c=37496,qc=37808,Xc=37809,jc=37810,Yc=37811,Kc=37812,Zc=37813,Jc=37814,Qc=37815,th=37816,eh=37817,nh=37818,ih=37819,sh=37820,oh=37821,Ta=36492,rh=36494,ah=36495,Em=36283,lh=36284,ch=36285,hh=36286,uC=3200,dC=3201,Tm=0,fC=1,as="",Bn="srgb",Zo="srgb-linear",nl="linear",Re="srgb",uo=7680,qd=519,pC=512,mC=513,gC=514,Am=515,_C=516,vC=517,xC=518,bC=519,Xd=35044,jd="300 es",Bi=2e3,Oa=2001;class Jo{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});const n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){if(this._listeners===void 0)return!1;const n=this._listeners;return n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){if(this._listeners===void 0)return;const s=this._listeners[t];if(s!==void 0){const o=s.indexOf(e);o!==-1&&s.splice(o,1)}}dispatchEvent(t){if(this._listeners===void 0)return;const n=this._listeners[t.type];if(n!==void 0){t.target=this;const s=n.slice(0);for(let o=0,a=s.length;o<a;o++)s[o].call(this,t);t.target=null}}}const gn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Ll=Math.PI/180,uh=180/Math.PI;function Cr(){const i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(gn[i&255]+gn[i>>8&255]+gn[i>>16&255]+gn[i>>24&255]+"-"+gn[t&255]+gn[t>>8&255]+"-"+gn[t>>16&15|64]+gn[t>>24&255]+"-"+gn[e&63|128]+gn[e>>8&255]+"-"+gn[e>>16&255]+gn[e>>24&255]+gn[n&255]+gn[n>>8&255]+gn[n>>16&255]+gn[n>>24&255]).toLowerCase()}function Cn(i,t,e){return Math.max(t,Math.min(e,i))}function yC(i,t){return(i%t+t)%t}function Nl(i,t,e){return(1-e)*i+e*t}function lr(i,t){switch(t.constructor){case Float32Array:return i;case Uint32Array:return i/4294967295;case Uint16Array:return i/65535;case Uint8Array:return i/255;case Int32Array:return Math.max(i/2147483647,-1);case Int16Array:return Math.max(i/32767,-1);case Int8Array:return Math.max(i/127,-1);default:throw new Error("Invalid component type.")}}function Rn(i,t){switch(t.constructor){case Float32Array:return i;case Uint32Array:return Math.round(i*4294967295);case Uint16Array:return Math.round(i*65535);case Uint8Array:return Math.round(i*255);case Int32Array:return Math.round(i*2147483647);case Int16Array:return Math.round(i*32767);case Int8Array:return Math.round(i*127);default:throw new Error("Invalid component type.")}}class ve{constructor(t=0,e=0){ve.prototype.isVector2=!0,this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){const e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this}clampLength(t,e){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Math.max(t,Math.min(e,n)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){const e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;const n=this.dot(t)/e;return Math.acos(Cn(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){const e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){const n=Math.cos(e),s=Math.sin(e),o=this.x-t.x,a=this.y-t.y;return this.x=o*n-a*s+t.x,this.y=o*s+a*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}}class ne{constructor(t,e,n,s,o,a,r,l,c){ne.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,o,a,r,l,c)}set(t,e,n,s,o,a,r,l,c){const h=this.elements;return h[0]=t,h[1]=s,h[2]=r,h[3]=e,h[4]=o,h[5]=l,h[6]=n,h[7]=a,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){const e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){const e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){const n=t.elements,s=e.elements,o=this.elements,a=n[0],r=n[3],l=n[6],c=n[1],h=n[4],u=n[7],d=n[2],p=n[5],_=n[8],g=s[0],m=s[3],f=s[6],M=s[1],S=s[4],x=s[7],F=s[2],L=s[5],A=s[8];return o[0]=a*g+r*M+l*F,o[3]=a*m+r*S+l*L,o[6]=a*f+r*x+l*A,o[1]=c*g+h*M+u*F,o[4]=c*m+h*S+u*L,o[7]=c*f+h*x+u*A,o[2]=d*g+p*M+_*F,o[5]=d*m+p*S+_*L,o[8]=d*f+p*x+_*A,this}multiplyScalar(t){const e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){const t=this.elements,e=t[0],n=t[1],s=t[2],o=t[3],a=t[4],r=t[5],l=t[6],c=t[7],h=t[8];return e*a*h-e*r*c-n*o*h+n*r*l+s*o*c-s*a*l}invert(){const t=this.elements,e=t[0],n=t[1],s=t[2],o=t[3],a=t[4],r=t[5],l=t[6],c=t[7],h=t[8],u=h*a-r*c,d=r*l-h*o,p=c*o-a*l,_=e*u+n*d+s*p;if(_===0)return this.set(0,0,0,0,0,0,0,0,0);const g=1/_;return t[0]=u*g,t[1]=(s*c-h*n)*g,t[2]=(r*n-s*a)*g,t[3]=d*g,t[4]=(h*e-s*l)*g,t[5]=(s*o-r*e)*g,t[6]=p*g,t[7]=(n*l-c*e)*g,t[8]=(a*e-n*o)*g,this}transpose(){let t;const e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){const e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,o,a,r){const l=Math.cos(o),c=Math.sin(o);return this.set(n*l,n*c,-n*(l*a+c*r)+a+t,-s*c,s*l,-s*(-c*a+l*r)+r+e,0,0,1),this}scale(t,e){return this.premultiply(Dl.makeScale(t,e)),this}rotate(t){return this.premultiply(Dl.makeRotation(-t)),this}translate(t,e){return this.premultiply(Dl.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){const e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){const e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){const n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}}const Dl=new ne;function Rm(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function Ba(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function MC(){const i=Ba("canvas");return i.style.display="block",i}const Yd={};function vr(i){i in Yd||(Yd[i]=!0,console.warn(i))}function SC(i,t,e){return new Promise(function(n,s){function o(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(o,e);break;default:n()}}setTimeout(o,e)})}function wC(i){const t=i.elements;t[2]=.5*t[2]+.5*t[3],t[6]=.5*t[6]+.5*t[7],t[10]=.5*t[10]+.5*t[11],t[14]=.5*t[14]+.5*t[15]}function EC(i){const t=i.elements;t[11]===-1?(t[10]=-t[10]-1,t[14]=-t[14]):(t[10]=-t[10],t[14]=-t[14]+1)}const ge={enabled:!0,workingColorSpace:Zo,spaces:{},convert:function(i,t,e){return this.enabled===!1||t===e||!t||!e||(this.spaces[t].transfer===Re&&(i.r=Gi(i.r),i.g=Gi(i.g),i.b=Gi(i.b)),this.spaces[t].primaries!==this.spaces[e].primaries&&(i.applyMatrix3(this.spaces[t].toXYZ),i.applyMatrix3(this.spaces[e].fromXYZ)),this.spaces[e].transfer===Re&&(i.r=Io(i.r),i.g=Io(i.g),i.b=Io(i.b))),i},fromWorkingColorSpace:function(i,t){return this.convert(i,this.workingColorSpace,t)},toWorkingColorSpace:function(i,t){return this.convert(i,t,this.workingColorSpace)},getPrimaries:function(i){return this.spaces[i].primaries},getTransfer:function(i){return i===as?nl:this.spaces[i].transfer},getLuminanceCoefficients:function(i,t=this.workingColorSpace){return i.fromArray(this.spaces[t].luminanceCoefficients)},define:function(i){Object.assign(this.spaces,i)},_getMatrix:function(i,t,e){return i.copy(this.spaces[t].toXYZ).multiply(this.spaces[e].fromXYZ)},_getDrawingBufferColorSpace:function(i){return this.spaces[i].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(i=this.workingColorSpace){return this.spaces[i].workingColorSpaceConfig.unpackColorSpace}};function Gi(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Io(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}const Kd=[.64,.33,.3,.6,.15,.06],Zd=[.2126,.7152,.0722],Jd=[.3127,.329],Qd=new ne().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),tf=new ne().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);ge.define({[Zo]:{primaries:Kd,whitePoint:Jd,transfer:nl,toXYZ:Qd,fromXYZ:tf,luminanceCoefficients:Zd,workingColorSpaceConfig:{unpackColorSpace:Bn},outputColorSpaceConfig:{drawingBufferColorSpace:Bn}},[Bn]:{primaries:Kd,whitePoint:Jd,transfer:Re,toXYZ:Qd,fromXYZ:tf,luminanceCoefficients:Zd,outputColorSpaceConfig:{drawingBufferColorSpace:Bn}}});let fo;class TC{static getDataURL(t){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let e;if(t instanceof HTMLCanvasElement)e=t;else{fo===void 0&&(fo=Ba("canvas")),fo.width=t.width,fo.height=t.height;const n=fo.getContext("2d");t instanceof ImageData?n.putImageData(t,0,0):n.drawImage(t,0,0,t.width,t.height),e=fo}return e.width>2048||e.height>2048?(console.warn("THREE.ImageUtils.getDataURL: Image converted to jpg for performance reasons",t),e.toDataURL("image/jpeg",.6)):e.toDataURL("image/png")}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){const e=Ba("canvas");e.width=t.width,e.height=t.height;const n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);const s=n.getImageData(0,0,t.width,t.height),o=s.data;for(let a=0;a<o.length;a++)o[a]=Gi(o[a]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){const e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(Gi(e[n]/255)*255):e[n]=Gi(e[n]);return{data:e,width:t.width,height:t.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}}let AC=0;class Cm{constructor(t=null){this.isSource=!0,Object.defineProperty(this,"id",{value:AC++}),this.uuid=Cr(),this.data=t,this.dataReady=!0,this.version=0}set needsUpdate(t){t===!0&&this.version++}toJSON(t){const e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];const n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let o;if(Array.isArray(s)){o=[];for(let a=0,r=s.length;a<r;a++)s[a].isDataTexture?o.push(Il(s[a].image)):o.push(Il(s[a]))}else o=Il(s);n.url=o}return e||(t.images[this.uuid]=n),n}}function Il(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?TC.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}let RC=0;class En extends Jo{constructor(t=En.DEFAULT_IMAGE,e=En.DEFAULT_MAPPING,n=Os,s=Os,o=bi,a=Bs,r=li,l=$i,c=En.DEFAULT_ANISOTROPY,h=as){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:RC++}),this.uuid=Cr(),this.name="",this.source=new Cm(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=o,this.minFilter=a,this.anisotropy=c,this.format=r,this.internalFormat=null,this.type=l,this.offset=new ve(0,0),this.repeat=new ve(1,1),this.center=new ve(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ne,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.version=0,this.onUpdate=null,this.isRenderTargetTexture=!1,this.pmremVersion=0}get image(){return this.source.data}set image(t=null){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}toJSON(t){const e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];const n={metadata:{version:4.6,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==mm)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Fa:t.x=t.x-Math.floor(t.x);break;case Os:t.x=t.x<0?0:1;break;case Oc:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Fa:t.y=t.y-Math.floor(t.y);break;case Os:t.y=t.y<0?0:1;break;case Oc:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}}En.DEFAULT_IMAGE=null;En.DEFAULT_MAPPING=mm;En.DEFAULT_ANISOTROPY=1;class We{constructor(t=0,e=0,n=0,s=1){We.prototype.isVector4=!0,this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){const e=this.x,n=this.y,s=this.z,o=this.w,a=t.elements;return this.x=a[0]*e+a[4]*n+a[8]*s+a[12]*o,this.y=a[1]*e+a[5]*n+a[9]*s+a[13]*o,this.z=a[2]*e+a[6]*n+a[10]*s+a[14]*o,this.w=a[3]*e+a[7]*n+a[11]*s+a[15]*o,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);const e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,o;const l=t.elements,c=l[0],h=l[4],u=l[8],d=l[1],p=l[5],_=l[9],g=l[2],m=l[6],f=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-g)<.01&&Math.abs(_-m)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+g)<.1&&Math.abs(_+m)<.1&&Math.abs(c+p+f-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;const S=(c+1)/2,x=(p+1)/2,F=(f+1)/2,L=(h+d)/4,A=(u+g)/4,D=(_+m)/4;return S>x&&S>F?S<.01?(n=0,s=.707106781,o=.707106781):(n=Math.sqrt(S),s=L/n,o=A/n):x>F?x<.01?(n=.707106781,s=0,o=.707106781):(s=Math.sqrt(x),n=L/s,o=D/s):F<.01?(n=.707106781,s=.707106781,o=0):(o=Math.sqrt(F),n=A/o,s=D/o),this.set(n,s,o,e),this}let M=Math.sqrt((m-_)*(m-_)+(u-g)*(u-g)+(d-h)*(d-h));return Math.abs(M)<.001&&(M=1),this.x=(m-_)/M,this.y=(u-g)/M,this.z=(d-h)/M,this.w=Math.acos((c+p+f-1)/2),this}setFromMatrixPosition(t){const e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this.z=Math.max(t.z,Math.min(e.z,this.z)),this.w=Math.max(t.w,Math.min(e.w,this.w)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this.z=Math.max(t,Math.min(e,this.z)),this.w=Math.max(t,Math.min(e,this.w)),this}clampLength(t,e){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Math.max(t,Math.min(e,n)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}}class CC extends Jo{constructor(t=1,e=1,n={}){super(),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=1,this.scissor=new We(0,0,t,e),this.scissorTest=!1,this.viewport=new We(0,0,t,e);const s={width:t,height:e,depth:1};n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:bi,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1},n);const o=new En(s,n.mapping,n.wrapS,n.wrapT,n.magFilter,n.minFilter,n.format,n.type,n.anisotropy,n.colorSpace);o.flipY=!1,o.generateMipmaps=n.generateMipmaps,o.internalFormat=n.internalFormat,this.textures=[];const a=n.count;for(let r=0;r<a;r++)this.textures[r]=o.clone(),this.textures[r].isRenderTargetTexture=!0;this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.depthTexture=n.depthTexture,this.samples=n.samples}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,o=this.textures.length;s<o;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n;this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let n=0,s=t.textures.length;n<s;n++)this.textures[n]=t.textures[n].clone(),this.textures[n].isRenderTargetTexture=!0;const e=Object.assign({},t.texture.image);return this.texture.source=new Cm(e),this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,t.depthTexture!==null&&(this.depthTexture=t.depthTexture.clone()),this.samples=t.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}}class js extends CC{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}}class Pm extends En{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=ci,this.minFilter=ci,this.wrapR=Os,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}}class PC extends En{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=ci,this.minFilter=ci,this.wrapR=Os,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}}class Pr{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,o,a,r){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3];const d=o[a+0],p=o[a+1],_=o[a+2],g=o[a+3];if(r===0){t[e+0]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u;return}if(r===1){t[e+0]=d,t[e+1]=p,t[e+2]=_,t[e+3]=g;return}if(u!==g||l!==d||c!==p||h!==_){let m=1-r;const f=l*d+c*p+h*_+u*g,M=f>=0?1:-1,S=1-f*f;if(S>Number.EPSILON){const F=Math.sqrt(S),L=Math.atan2(F,f*M);m=Math.sin(m*L)/F,r=Math.sin(r*L)/F}const x=r*M;if(l=l*m+d*x,c=c*m+p*x,h=h*m+_*x,u=u*m+g*x,m===1-r){const F=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=F,c*=F,h*=F,u*=F}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,n,s,o,a){const r=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=o[a],d=o[a+1],p=o[a+2],_=o[a+3];return t[e]=r*_+h*u+l*p-c*d,t[e+1]=l*_+h*d+c*u-r*p,t[e+2]=c*_+h*p+r*d-l*u,t[e+3]=h*_-r*u-l*d-c*p,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){const n=t._x,s=t._y,o=t._z,a=t._order,r=Math.cos,l=Math.sin,c=r(n/2),h=r(s/2),u=r(o/2),d=l(n/2),p=l(s/2),_=l(o/2);switch(a){case"XYZ":this._x=d*h*u+c*p*_,this._y=c*p*u-d*h*_,this._z=c*h*_+d*p*u,this._w=c*h*u-d*p*_;break;case"YXZ":this._x=d*h*u+c*p*_,this._y=c*p*u-d*h*_,this._z=c*h*_-d*p*u,this._w=c*h*u+d*p*_;break;case"ZXY":this._x=d*h*u-c*p*_,this._y=c*p*u+d*h*_,this._z=c*h*_+d*p*u,this._w=c*h*u-d*p*_;break;case"ZYX":this._x=d*h*u-c*p*_,this._y=c*p*u+d*h*_,this._z=c*h*_-d*p*u,this._w=c*h*u+d*p*_;break;case"YZX":this._x=d*h*u+c*p*_,this._y=c*p*u+d*h*_,this._z=c*h*_-d*p*u,this._w=c*h*u-d*p*_;break;case"XZY":this._x=d*h*u-c*p*_,this._y=c*p*u-d*h*_,this._z=c*h*_+d*p*u,this._w=c*h*u+d*p*_;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+a)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){const n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){const e=t.elements,n=e[0],s=e[4],o=e[8],a=e[1],r=e[5],l=e[9],c=e[2],h=e[6],u=e[10],d=n+r+u;if(d>0){const p=.5/Math.sqrt(d+1);this._w=.25/p,this._x=(h-l)*p,this._y=(o-c)*p,this._z=(a-s)*p}else if(n>r&&n>u){const p=2*Math.sqrt(1+n-r-u);this._w=(h-l)/p,this._x=.25*p,this._y=(s+a)/p,this._z=(o+c)/p}else if(r>u){const p=2*Math.sqrt(1+r-n-u);this._w=(o-c)/p,this._x=(s+a)/p,this._y=.25*p,this._z=(l+h)/p}else{const p=2*Math.sqrt(1+u-n-r);this._w=(a-s)/p,this._x=(o+c)/p,this._y=(l+h)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<Number.EPSILON?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(Cn(this.dot(t),-1,1)))}rotateTowards(t,e){const n=this.angleTo(t);if(n===0)return this;const s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){const n=t._x,s=t._y,o=t._z,a=t._w,r=e._x,l=e._y,c=e._z,h=e._w;return this._x=n*h+a*r+s*c-o*l,this._y=s*h+a*l+o*r-n*c,this._z=o*h+a*c+n*l-s*r,this._w=a*h-n*r-s*l-o*c,this._onChangeCallback(),this}slerp(t,e){if(e===0)return this;if(e===1)return this.copy(t);const n=this._x,s=this._y,o=this._z,a=this._w;let r=a*t._w+n*t._x+s*t._y+o*t._z;if(r<0?(this._w=-t._w,this._x=-t._x,this._y=-t._y,this._z=-t._z,r=-r):this.copy(t),r>=1)return this._w=a,this._x=n,this._y=s,this._z=o,this;const l=1-r*r;if(l<=Number.EPSILON){const p=1-e;return this._w=p*a+e*this._w,this._x=p*n+e*this._x,this._y=p*s+e*this._y,this._z=p*o+e*this._z,this.normalize(),this}const c=Math.sqrt(l),h=Math.atan2(c,r),u=Math.sin((1-e)*h)/c,d=Math.sin(e*h)/c;return this._w=a*u+this._w*d,this._x=n*u+this._x*d,this._y=s*u+this._y*d,this._z=o*u+this._z*d,this._onChangeCallback(),this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){const t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),o=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),o*Math.sin(e),o*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}}class et{constructor(t=0,e=0,n=0){et.prototype.isVector3=!0,this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(ef.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(ef.setFromAxisAngle(t,e))}applyMatrix3(t){const e=this.x,n=this.y,s=this.z,o=t.elements;return this.x=o[0]*e+o[3]*n+o[6]*s,this.y=o[1]*e+o[4]*n+o[7]*s,this.z=o[2]*e+o[5]*n+o[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){const e=this.x,n=this.y,s=this.z,o=t.elements,a=1/(o[3]*e+o[7]*n+o[11]*s+o[15]);return this.x=(o[0]*e+o[4]*n+o[8]*s+o[12])*a,this.y=(o[1]*e+o[5]*n+o[9]*s+o[13])*a,this.z=(o[2]*e+o[6]*n+o[10]*s+o[14])*a,this}applyQuaternion(t){const e=this.x,n=this.y,s=this.z,o=t.x,a=t.y,r=t.z,l=t.w,c=2*(a*s-r*n),h=2*(r*e-o*s),u=2*(o*n-a*e);return this.x=e+l*c+a*u-r*h,this.y=n+l*h+r*c-o*u,this.z=s+l*u+o*h-a*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){const e=this.x,n=this.y,s=this.z,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s,this.y=o[1]*e+o[5]*n+o[9]*s,this.z=o[2]*e+o[6]*n+o[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this.z=Math.max(t.z,Math.min(e.z,this.z)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this.z=Math.max(t,Math.min(e,this.z)),this}clampLength(t,e){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Math.max(t,Math.min(e,n)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){const n=t.x,s=t.y,o=t.z,a=e.x,r=e.y,l=e.z;return this.x=s*l-o*r,this.y=o*a-n*l,this.z=n*r-s*a,this}projectOnVector(t){const e=t.lengthSq();if(e===0)return this.set(0,0,0);const n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return Ul.copy(this).projectOnVector(t),this.sub(Ul)}reflect(t){return this.sub(Ul.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){const e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;const n=this.dot(t)/e;return Math.acos(Cn(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){const e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){const s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){const e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){const e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){const t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}}const Ul=new et,ef=new Pr;class Lr{constructor(t=new et(1/0,1/0,1/0),e=new et(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(ti.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(ti.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){const n=ti.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);const n=t.geometry;if(n!==void 0){const o=n.getAttribute("position");if(e===!0&&o!==void 0&&t.isInstancedMesh!==!0)for(let a=0,r=o.count;a<r;a++)t.isMesh===!0?t.getVertexPosition(a,ti):ti.fromBufferAttribute(o,a),ti.applyMatrix4(t.matrixWorld),this.expandByPoint(ti);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),jr.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),jr.copy(n.boundingBox)),jr.applyMatrix4(t.matrixWorld),this.union(jr)}const s=t.children;for(let o=0,a=s.length;o<a;o++)this.expandByObject(s[o],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,ti),ti.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(cr),Yr.subVectors(this.max,cr),po.subVectors(t.a,cr),mo.subVectors(t.b,cr),go.subVectors(t.c,cr),Zi.subVectors(mo,po),Ji.subVectors(go,mo),ws.subVectors(po,go);let e=[0,-Zi.z,Zi.y,0,-Ji.z,Ji.y,0,-ws.z,ws.y,Zi.z,0,-Zi.x,Ji.z,0,-Ji.x,ws.z,0,-ws.x,-Zi.y,Zi.x,0,-Ji.y,Ji.x,0,-ws.y,ws.x,0];return!kl(e,po,mo,go,Yr)||(e=[1,0,0,0,1,0,0,0,1],!kl(e,po,mo,go,Yr))?!1:(Kr.crossVectors(Zi,Ji),e=[Kr.x,Kr.y,Kr.z],kl(e,po,mo,go,Yr))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,ti).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(ti).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Pi[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Pi[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Pi[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Pi[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Pi[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Pi[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Pi[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Pi[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Pi),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}}const Pi=[new et,new et,new et,new et,new et,new et,new et,new et],ti=new et,jr=new Lr,po=new et,mo=new et,go=new et,Zi=new et,Ji=new et,ws=new et,cr=new et,Yr=new et,Kr=new et,Es=new et;function kl(i,t,e,n,s){for(let o=0,a=i.length-3;o<=a;o+=3){Es.fromArray(i,o);const r=s.x*Math.abs(Es.x)+s.y*Math.abs(Es.y)+s.z*Math.abs(Es.z),l=t.dot(Es),c=e.dot(Es),h=n.dot(Es);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>r)return!1}return!0}const LC=new Lr,hr=new et,Fl=new et;class jh{constructor(t=new et,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){const n=this.center;e!==void 0?n.copy(e):LC.setFromPoints(t).getCenter(n);let s=0;for(let o=0,a=t.length;o<a;o++)s=Math.max(s,n.distanceToSquared(t[o]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){const e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){const n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;hr.subVectors(t,this.center);const e=hr.lengthSq();if(e>this.radius*this.radius){const n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(hr,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Fl.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(hr.copy(t.center).add(Fl)),this.expandByPoint(hr.copy(t.center).sub(Fl))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}}const Li=new et,Ol=new et,Zr=new et,Qi=new et,Bl=new et,Jr=new et,zl=new et;class Lm{constructor(t=new et,e=new et(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Li)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);const n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){const e=Li.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Li.copy(this.origin).addScaledVector(this.direction,e),Li.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){Ol.copy(t).add(e).multiplyScalar(.5),Zr.copy(e).sub(t).normalize(),Qi.copy(this.origin).sub(Ol);const o=t.distanceTo(e)*.5,a=-this.direction.dot(Zr),r=Qi.dot(this.direction),l=-Qi.dot(Zr),c=Qi.lengthSq(),h=Math.abs(1-a*a);let u,d,p,_;if(h>0)if(u=a*l-r,d=a*r-l,_=o*h,u>=0)if(d>=-_)if(d<=_){const g=1/h;u*=g,d*=g,p=u*(u+a*d+2*r)+d*(a*u+d+2*l)+c}else d=o,u=Math.max(0,-(a*d+r)),p=-u*u+d*(d+2*l)+c;else d=-o,u=Math.max(0,-(a*d+r)),p=-u*u+d*(d+2*l)+c;else d<=-_?(u=Math.max(0,-(-a*o+r)),d=u>0?-o:Math.min(Math.max(-o,-l),o),p=-u*u+d*(d+2*l)+c):d<=_?(u=0,d=Math.min(Math.max(-o,-l),o),p=d*(d+2*l)+c):(u=Math.max(0,-(a*o+r)),d=u>0?o:Math.min(Math.max(-o,-l),o),p=-u*u+d*(d+2*l)+c);else d=a>0?-o:o,u=Math.max(0,-(a*d+r)),p=-u*u+d*(d+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(Ol).addScaledVector(Zr,d),p}intersectSphere(t,e){Li.subVectors(t.center,this.origin);const n=Li.dot(this.direction),s=Li.dot(Li)-n*n,o=t.radius*t.radius;if(s>o)return null;const a=Math.sqrt(o-s),r=n-a,l=n+a;return l<0?null:r<0?this.at(l,e):this.at(r,e)}intersectsSphere(t){return this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){const e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;const n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){const n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){const e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,o,a,r,l;const c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(n=(t.min.x-d.x)*c,s=(t.max.x-d.x)*c):(n=(t.max.x-d.x)*c,s=(t.min.x-d.x)*c),h>=0?(o=(t.min.y-d.y)*h,a=(t.max.y-d.y)*h):(o=(t.max.y-d.y)*h,a=(t.min.y-d.y)*h),n>a||o>s||((o>n||isNaN(n))&&(n=o),(a<s||isNaN(s))&&(s=a),u>=0?(r=(t.min.z-d.z)*u,l=(t.max.z-d.z)*u):(r=(t.max.z-d.z)*u,l=(t.min.z-d.z)*u),n>l||r>s)||((r>n||n!==n)&&(n=r),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,Li)!==null}intersectTriangle(t,e,n,s,o){Bl.subVectors(e,t),Jr.subVectors(n,t),zl.crossVectors(Bl,Jr);let a=this.direction.dot(zl),r;if(a>0){if(s)return null;r=1}else if(a<0)r=-1,a=-a;else return null;Qi.subVectors(this.origin,t);const l=r*this.direction.dot(Jr.crossVectors(Qi,Jr));if(l<0)return null;const c=r*this.direction.dot(Bl.cross(Qi));if(c<0||l+c>a)return null;const h=-r*Qi.dot(zl);return h<0?null:this.at(h/a,o)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}}class He{constructor(t,e,n,s,o,a,r,l,c,h,u,d,p,_,g,m){He.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,o,a,r,l,c,h,u,d,p,_,g,m)}set(t,e,n,s,o,a,r,l,c,h,u,d,p,_,g,m){const f=this.elements;return f[0]=t,f[4]=e,f[8]=n,f[12]=s,f[1]=o,f[5]=a,f[9]=r,f[13]=l,f[2]=c,f[6]=h,f[10]=u,f[14]=d,f[3]=p,f[7]=_,f[11]=g,f[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new He().fromArray(this.elements)}copy(t){const e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){const e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){const e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){const e=this.elements,n=t.elements,s=1/_o.setFromMatrixColumn(t,0).length(),o=1/_o.setFromMatrixColumn(t,1).length(),a=1/_o.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*o,e[5]=n[5]*o,e[6]=n[6]*o,e[7]=0,e[8]=n[8]*a,e[9]=n[9]*a,e[10]=n[10]*a,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){const e=this.elements,n=t.x,s=t.y,o=t.z,a=Math.cos(n),r=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(o),u=Math.sin(o);if(t.order==="XYZ"){const d=a*h,p=a*u,_=r*h,g=r*u;e[0]=l*h,e[4]=-l*u,e[8]=c,e[1]=p+_*c,e[5]=d-g*c,e[9]=-r*l,e[2]=g-d*c,e[6]=_+p*c,e[10]=a*l}else if(t.order==="YXZ"){const d=l*h,p=l*u,_=c*h,g=c*u;e[0]=d+g*r,e[4]=_*r-p,e[8]=a*c,e[1]=a*u,e[5]=a*h,e[9]=-r,e[2]=p*r-_,e[6]=g+d*r,e[10]=a*l}else if(t.order==="ZXY"){const d=l*h,p=l*u,_=c*h,g=c*u;e[0]=d-g*r,e[4]=-a*u,e[8]=_+p*r,e[1]=p+_*r,e[5]=a*h,e[9]=g-d*r,e[2]=-a*c,e[6]=r,e[10]=a*l}else if(t.order==="ZYX"){const d=a*h,p=a*u,_=r*h,g=r*u;e[0]=l*h,e[4]=_*c-p,e[8]=d*c+g,e[1]=l*u,e[5]=g*c+d,e[9]=p*c-_,e[2]=-c,e[6]=r*l,e[10]=a*l}else if(t.order==="YZX"){const d=a*l,p=a*c,_=r*l,g=r*c;e[0]=l*h,e[4]=g-d*u,e[8]=_*u+p,e[1]=u,e[5]=a*h,e[9]=-r*h,e[2]=-c*h,e[6]=p*u+_,e[10]=d-g*u}else if(t.order==="XZY"){const d=a*l,p=a*c,_=r*l,g=r*c;e[0]=l*h,e[4]=-u,e[8]=c*h,e[1]=d*u+g,e[5]=a*h,e[9]=p*u-_,e[2]=_*u-p,e[6]=r*h,e[10]=g*u+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(NC,t,DC)}lookAt(t,e,n){const s=this.elements;return Un.subVectors(t,e),Un.lengthSq()===0&&(Un.z=1),Un.normalize(),ts.crossVectors(n,Un),ts.lengthSq()===0&&(Math.abs(n.z)===1?Un.x+=1e-4:Un.z+=1e-4,Un.normalize(),ts.crossVectors(n,Un)),ts.normalize(),Qr.crossVectors(Un,ts),s[0]=ts.x,s[4]=Qr.x,s[8]=Un.x,s[1]=ts.y,s[5]=Qr.y,s[9]=Un.y,s[2]=ts.z,s[6]=Qr.z,s[10]=Un.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){const n=t.elements,s=e.elements,o=this.elements,a=n[0],r=n[4],l=n[8],c=n[12],h=n[1],u=n[5],d=n[9],p=n[13],_=n[2],g=n[6],m=n[10],f=n[14],M=n[3],S=n[7],x=n[11],F=n[15],L=s[0],A=s[4],D=s[8],E=s[12],b=s[1],R=s[5],H=s[9],O=s[13],q=s[2],$=s[6],X=s[10],j=s[14],Q=s[3],at=s[7],lt=s[11],gt=s[15];return o[0]=a*L+r*b+l*q+c*Q,o[4]=a*A+r*R+l*$+c*at,o[8]=a*D+r*H+l*X+c*lt,o[12]=a*E+r*O+l*j+c*gt,o[1]=h*L+u*b+d*q+p*Q,o[5]=h*A+u*R+d*$+p*at,o[9]=h*D+u*H+d*X+p*lt,o[13]=h*E+u*O+d*j+p*gt,o[2]=_*L+g*b+m*q+f*Q,o[6]=_*A+g*R+m*$+f*at,o[10]=_*D+g*H+m*X+f*lt,o[14]=_*E+g*O+m*j+f*gt,o[3]=M*L+S*b+x*q+F*Q,o[7]=M*A+S*R+x*$+F*at,o[11]=M*D+S*H+x*X+F*lt,o[15]=M*E+S*O+x*j+F*gt,this}multiplyScalar(t){const e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){const t=this.elements,e=t[0],n=t[4],s=t[8],o=t[12],a=t[1],r=t[5],l=t[9],c=t[13],h=t[2],u=t[6],d=t[10],p=t[14],_=t[3],g=t[7],m=t[11],f=t[15];return _*(+o*l*u-s*c*u-o*r*d+n*c*d+s*r*p-n*l*p)+g*(+e*l*p-e*c*d+o*a*d-s*a*p+s*c*h-o*l*h)+m*(+e*c*u-e*r*p-o*a*u+n*a*p+o*r*h-n*c*h)+f*(-s*r*h-e*l*u+e*r*d+s*a*u-n*a*d+n*l*h)}transpose(){const t=this.elements;let e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){const s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){const t=this.elements,e=t[0],n=t[1],s=t[2],o=t[3],a=t[4],r=t[5],l=t[6],c=t[7],h=t[8],u=t[9],d=t[10],p=t[11],_=t[12],g=t[13],m=t[14],f=t[15],M=u*m*c-g*d*c+g*l*p-r*m*p-u*l*f+r*d*f,S=_*d*c-h*m*c-_*l*p+a*m*p+h*l*f-a*d*f,x=h*g*c-_*u*c+_*r*p-a*g*p-h*r*f+a*u*f,F=_*u*l-h*g*l-_*r*d+a*g*d+h*r*m-a*u*m,L=e*M+n*S+s*x+o*F;if(L===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);const A=1/L;return t[0]=M*A,t[1]=(g*d*o-u*m*o-g*s*p+n*m*p+u*s*f-n*d*f)*A,t[2]=(r*m*o-g*l*o+g*s*c-n*m*c-r*s*f+n*l*f)*A,t[3]=(u*l*o-r*d*o-u*s*c+n*d*c+r*s*p-n*l*p)*A,t[4]=S*A,t[5]=(h*m*o-_*d*o+_*s*p-e*m*p-h*s*f+e*d*f)*A,t[6]=(_*l*o-a*m*o-_*s*c+e*m*c+a*s*f-e*l*f)*A,t[7]=(a*d*o-h*l*o+h*s*c-e*d*c-a*s*p+e*l*p)*A,t[8]=x*A,t[9]=(_*u*o-h*g*o-_*n*p+e*g*p+h*n*f-e*u*f)*A,t[10]=(a*g*o-_*r*o+_*n*c-e*g*c-a*n*f+e*r*f)*A,t[11]=(h*r*o-a*u*o-h*n*c+e*u*c+a*n*p-e*r*p)*A,t[12]=F*A,t[13]=(h*g*s-_*u*s+_*n*d-e*g*d-h*n*m+e*u*m)*A,t[14]=(_*r*s-a*g*s-_*n*l+e*g*l+a*n*m-e*r*m)*A,t[15]=(a*u*s-h*r*s+h*n*l-e*u*l-a*n*d+e*r*d)*A,this}scale(t){const e=this.elements,n=t.x,s=t.y,o=t.z;return e[0]*=n,e[4]*=s,e[8]*=o,e[1]*=n,e[5]*=s,e[9]*=o,e[2]*=n,e[6]*=s,e[10]*=o,e[3]*=n,e[7]*=s,e[11]*=o,this}getMaxScaleOnAxis(){const t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){const e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){const e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){const e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){const n=Math.cos(e),s=Math.sin(e),o=1-n,a=t.x,r=t.y,l=t.z,c=o*a,h=o*r;return this.set(c*a+n,c*r-s*l,c*l+s*r,0,c*r+s*l,h*r+n,h*l-s*a,0,c*l-s*r,h*l+s*a,o*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,o,a){return this.set(1,n,o,0,t,1,a,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){const s=this.elements,o=e._x,a=e._y,r=e._z,l=e._w,c=o+o,h=a+a,u=r+r,d=o*c,p=o*h,_=o*u,g=a*h,m=a*u,f=r*u,M=l*c,S=l*h,x=l*u,F=n.x,L=n.y,A=n.z;return s[0]=(1-(g+f))*F,s[1]=(p+x)*F,s[2]=(_-S)*F,s[3]=0,s[4]=(p-x)*L,s[5]=(1-(d+f))*L,s[6]=(m+M)*L,s[7]=0,s[8]=(_+S)*A,s[9]=(m-M)*A,s[10]=(1-(d+g))*A,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){const s=this.elements;let o=_o.set(s[0],s[1],s[2]).length();const a=_o.set(s[4],s[5],s[6]).length(),r=_o.set(s[8],s[9],s[10]).length();this.determinant()<0&&(o=-o),t.x=s[12],t.y=s[13],t.z=s[14],ei.copy(this);const c=1/o,h=1/a,u=1/r;return ei.elements[0]*=c,ei.elements[1]*=c,ei.elements[2]*=c,ei.elements[4]*=h,ei.elements[5]*=h,ei.elements[6]*=h,ei.elements[8]*=u,ei.elements[9]*=u,ei.elements[10]*=u,e.setFromRotationMatrix(ei),n.x=o,n.y=a,n.z=r,this}makePerspective(t,e,n,s,o,a,r=Bi){const l=this.elements,c=2*o/(e-t),h=2*o/(n-s),u=(e+t)/(e-t),d=(n+s)/(n-s);let p,_;if(r===Bi)p=-(a+o)/(a-o),_=-2*a*o/(a-o);else if(r===Oa)p=-a/(a-o),_=-a*o/(a-o);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+r);return l[0]=c,l[4]=0,l[8]=u,l[12]=0,l[1]=0,l[5]=h,l[9]=d,l[13]=0,l[2]=0,l[6]=0,l[10]=p,l[14]=_,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(t,e,n,s,o,a,r=Bi){const l=this.elements,c=1/(e-t),h=1/(n-s),u=1/(a-o),d=(e+t)*c,p=(n+s)*h;let _,g;if(r===Bi)_=(a+o)*u,g=-2*u;else if(r===Oa)_=o*u,g=-1*u;else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+r);return l[0]=2*c,l[4]=0,l[8]=0,l[12]=-d,l[1]=0,l[5]=2*h,l[9]=0,l[13]=-p,l[2]=0,l[6]=0,l[10]=g,l[14]=-_,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(t){const e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){const n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}}const _o=new et,ei=new He,NC=new et(0,0,0),DC=new et(1,1,1),ts=new et,Qr=new et,Un=new et,nf=new He,sf=new Pr;class Ei{constructor(t=0,e=0,n=0,s=Ei.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){const s=t.elements,o=s[0],a=s[4],r=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],p=s[10];switch(e){case"XYZ":this._y=Math.asin(Cn(r,-1,1)),Math.abs(r)<.9999999?(this._x=Math.atan2(-h,p),this._z=Math.atan2(-a,o)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Cn(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(r,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,o),this._z=0);break;case"ZXY":this._x=Math.asin(Cn(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,p),this._z=Math.atan2(-a,c)):(this._y=0,this._z=Math.atan2(l,o));break;case"ZYX":this._y=Math.asin(-Cn(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,p),this._z=Math.atan2(l,o)):(this._x=0,this._z=Math.atan2(-a,c));break;case"YZX":this._z=Math.asin(Cn(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,o)):(this._x=0,this._y=Math.atan2(r,p));break;case"XZY":this._z=Math.asin(-Cn(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(r,o)):(this._x=Math.atan2(-h,p),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return nf.makeRotationFromQuaternion(t),this.setFromRotationMatrix(nf,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return sf.setFromEuler(this),this.setFromQuaternion(sf,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}}Ei.DEFAULT_ORDER="XYZ";class Yh{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}}let IC=0;const of=new et,vo=new Pr,Ni=new He,ta=new et,ur=new et,UC=new et,kC=new Pr,rf=new et(1,0,0),af=new et(0,1,0),lf=new et(0,0,1),cf={type:"added"},FC={type:"removed"},xo={type:"childadded",child:null},Hl={type:"childremoved",child:null};class fn extends Jo{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:IC++}),this.uuid=Cr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=fn.DEFAULT_UP.clone();const t=new et,e=new Ei,n=new Pr,s=new et(1,1,1);function o(){n.setFromEuler(e,!1)}function a(){e.setFromQuaternion(n,void 0,!1)}e._onChange(o),n._onChange(a),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new He},normalMatrix:{value:new ne}}),this.matrix=new He,this.matrixWorld=new He,this.matrixAutoUpdate=fn.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=fn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Yh,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return vo.setFromAxisAngle(t,e),this.quaternion.multiply(vo),this}rotateOnWorldAxis(t,e){return vo.setFromAxisAngle(t,e),this.quaternion.premultiply(vo),this}rotateX(t){return this.rotateOnAxis(rf,t)}rotateY(t){return this.rotateOnAxis(af,t)}rotateZ(t){return this.rotateOnAxis(lf,t)}translateOnAxis(t,e){return of.copy(t).applyQuaternion(this.quaternion),this.position.add(of.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(rf,t)}translateY(t){return this.translateOnAxis(af,t)}translateZ(t){return this.translateOnAxis(lf,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(Ni.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?ta.copy(t):ta.set(t,e,n);const s=this.parent;this.updateWorldMatrix(!0,!1),ur.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ni.lookAt(ur,ta,this.up):Ni.lookAt(ta,ur,this.up),this.quaternion.setFromRotationMatrix(Ni),s&&(Ni.extractRotation(s.matrixWorld),vo.setFromRotationMatrix(Ni),this.quaternion.premultiply(vo.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(cf),xo.child=t,this.dispatchEvent(xo),xo.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}const e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(FC),Hl.child=t,this.dispatchEvent(Hl),Hl.child=null),this}removeFromParent(){const t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),Ni.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),Ni.multiply(t.parent.matrixWorld)),t.applyMatrix4(Ni),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(cf),xo.child=t,this.dispatchEvent(xo),xo.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){const a=this.children[n].getObjectByProperty(t,e);if(a!==void 0)return a}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);const s=this.children;for(let o=0,a=s.length;o<a;o++)s[o].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ur,t,UC),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ur,kC,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);const e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}traverse(t){t(this);const e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);const e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){const e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);const e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e){const n=this.parent;if(t===!0&&n!==null&&n.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),e===!0){const s=this.children;for(let o=0,a=s.length;o<a;o++)s[o].updateWorldMatrix(!1,!0)}}toJSON(t){const e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.6,type:"Object",generator:"Object3D.toJSON"});const s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.visibility=this._visibility,s.active=this._active,s.bounds=this._bounds.map(r=>({boxInitialized:r.boxInitialized,boxMin:r.box.min.toArray(),boxMax:r.box.max.toArray(),sphereInitialized:r.sphereInitialized,sphereRadius:r.sphere.radius,sphereCenter:r.sphere.center.toArray()})),s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.geometryCount=this._geometryCount,s.matricesTexture=this._matricesTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere={center:s.boundingSphere.center.toArray(),radius:s.boundingSphere.radius}),this.boundingBox!==null&&(s.boundingBox={min:s.boundingBox.min.toArray(),max:s.boundingBox.max.toArray()}));function o(r,l){return r[l.uuid]===void 0&&(r[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=o(t.geometries,this.geometry);const r=this.geometry.parameters;if(r!==void 0&&r.shapes!==void 0){const l=r.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){const u=l[c];o(t.shapes,u)}else o(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(o(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){const r=[];for(let l=0,c=this.material.length;l<c;l++)r.push(o(t.materials,this.material[l]));s.material=r}else s.material=o(t.materials,this.material);if(this.children.length>0){s.children=[];for(let r=0;r<this.children.length;r++)s.children.push(this.children[r].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let r=0;r<this.animations.length;r++){const l=this.animations[r];s.animations.push(o(t.animations,l))}}if(e){const r=a(t.geometries),l=a(t.materials),c=a(t.textures),h=a(t.images),u=a(t.shapes),d=a(t.skeletons),p=a(t.animations),_=a(t.nodes);r.length>0&&(n.geometries=r),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),d.length>0&&(n.skeletons=d),p.length>0&&(n.animations=p),_.length>0&&(n.nodes=_)}return n.object=s,n;function a(r){const l=[];for(const c in r){const h=r[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){const s=t.children[n];this.add(s.clone())}return this}}fn.DEFAULT_UP=new et(0,1,0);fn.DEFAULT_MATRIX_AUTO_UPDATE=!0;fn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;const ni=new et,Di=new et,Vl=new et,Ii=new et,bo=new et,yo=new et,hf=new et,Gl=new et,Wl=new et,$l=new et,ql=new We,Xl=new We,jl=new We;class ai{constructor(t=new et,e=new et,n=new et){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),ni.subVectors(t,e),s.cross(ni);const o=s.lengthSq();return o>0?s.multiplyScalar(1/Math.sqrt(o)):s.set(0,0,0)}static getBarycoord(t,e,n,s,o){ni.subVectors(s,e),Di.subVectors(n,e),Vl.subVectors(t,e);const a=ni.dot(ni),r=ni.dot(Di),l=ni.dot(Vl),c=Di.dot(Di),h=Di.dot(Vl),u=a*c-r*r;if(u===0)return o.set(0,0,0),null;const d=1/u,p=(c*l-r*h)*d,_=(a*h-r*l)*d;return o.set(1-p-_,_,p)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,Ii)===null?!1:Ii.x>=0&&Ii.y>=0&&Ii.x+Ii.y<=1}static getInterpolation(t,e,n,s,o,a,r,l){return this.getBarycoord(t,e,n,s,Ii)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(o,Ii.x),l.addScaledVector(a,Ii.y),l.addScaledVector(r,Ii.z),l)}static getInterpolatedAttribute(t,e,n,s,o,a){return ql.setScalar(0),Xl.setScalar(0),jl.setScalar(0),ql.fromBufferAttribute(t,e),Xl.fromBufferAttribute(t,n),jl.fromBufferAttribute(t,s),a.setScalar(0),a.addScaledVector(ql,o.x),a.addScaledVector(Xl,o.y),a.addScaledVector(jl,o.z),a}static isFrontFacing(t,e,n,s){return ni.subVectors(n,e),Di.subVectors(t,e),ni.cross(Di).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return ni.subVectors(this.c,this.b),Di.subVectors(this.a,this.b),ni.cross(Di).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return ai.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return ai.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,o){return ai.getInterpolation(t,this.a,this.b,this.c,e,n,s,o)}containsPoint(t){return ai.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return ai.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){const n=this.a,s=this.b,o=this.c;let a,r;bo.subVectors(s,n),yo.subVectors(o,n),Gl.subVectors(t,n);const l=bo.dot(Gl),c=yo.dot(Gl);if(l<=0&&c<=0)return e.copy(n);Wl.subVectors(t,s);const h=bo.dot(Wl),u=yo.dot(Wl);if(h>=0&&u<=h)return e.copy(s);const d=l*u-h*c;if(d<=0&&l>=0&&h<=0)return a=l/(l-h),e.copy(n).addScaledVector(bo,a);$l.subVectors(t,o);const p=bo.dot($l),_=yo.dot($l);if(_>=0&&p<=_)return e.copy(o);const g=p*c-l*_;if(g<=0&&c>=0&&_<=0)return r=c/(c-_),e.copy(n).addScaledVector(yo,r);const m=h*_-p*u;if(m<=0&&u-h>=0&&p-_>=0)return hf.subVectors(o,s),r=(u-h)/(u-h+(p-_)),e.copy(s).addScaledVector(hf,r);const f=1/(m+g+d);return a=g*f,r=d*f,e.copy(n).addScaledVector(bo,a).addScaledVector(yo,r)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}}const Nm={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},es={h:0,s:0,l:0},ea={h:0,s:0,l:0};function Yl(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}class de{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){const s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=Bn){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,ge.toWorkingColorSpace(this,e),this}setRGB(t,e,n,s=ge.workingColorSpace){return this.r=t,this.g=e,this.b=n,ge.toWorkingColorSpace(this,s),this}setHSL(t,e,n,s=ge.workingColorSpace){if(t=yC(t,1),e=Cn(e,0,1),n=Cn(n,0,1),e===0)this.r=this.g=this.b=n;else{const o=n<=.5?n*(1+e):n+e-n*e,a=2*n-o;this.r=Yl(a,o,t+1/3),this.g=Yl(a,o,t),this.b=Yl(a,o,t-1/3)}return ge.toWorkingColorSpace(this,s),this}setStyle(t,e=Bn){function n(o){o!==void 0&&parseFloat(o)<1&&console.warn("THREE.Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let o;const a=s[1],r=s[2];switch(a){case"rgb":case"rgba":if(o=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(r))return n(o[4]),this.setRGB(Math.min(255,parseInt(o[1],10))/255,Math.min(255,parseInt(o[2],10))/255,Math.min(255,parseInt(o[3],10))/255,e);if(o=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(r))return n(o[4]),this.setRGB(Math.min(100,parseInt(o[1],10))/100,Math.min(100,parseInt(o[2],10))/100,Math.min(100,parseInt(o[3],10))/100,e);break;case"hsl":case"hsla":if(o=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(r))return n(o[4]),this.setHSL(parseFloat(o[1])/360,parseFloat(o[2])/100,parseFloat(o[3])/100,e);break;default:console.warn("THREE.Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){const o=s[1],a=o.length;if(a===3)return this.setRGB(parseInt(o.charAt(0),16)/15,parseInt(o.charAt(1),16)/15,parseInt(o.charAt(2),16)/15,e);if(a===6)return this.setHex(parseInt(o,16),e);console.warn("THREE.Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=Bn){const n=Nm[t.toLowerCase()];return n!==void 0?this.setHex(n,e):console.warn("THREE.Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Gi(t.r),this.g=Gi(t.g),this.b=Gi(t.b),this}copyLinearToSRGB(t){return this.r=Io(t.r),this.g=Io(t.g),this.b=Io(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=Bn){return ge.fromWorkingColorSpace(_n.copy(this),t),Math.round(Cn(_n.r*255,0,255))*65536+Math.round(Cn(_n.g*255,0,255))*256+Math.round(Cn(_n.b*255,0,255))}getHexString(t=Bn){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=ge.workingColorSpace){ge.fromWorkingColorSpace(_n.copy(this),e);const n=_n.r,s=_n.g,o=_n.b,a=Math.max(n,s,o),r=Math.min(n,s,o);let l,c;const h=(r+a)/2;if(r===a)l=0,c=0;else{const u=a-r;switch(c=h<=.5?u/(a+r):u/(2-a-r),a){case n:l=(s-o)/u+(s<o?6:0);break;case s:l=(o-n)/u+2;break;case o:l=(n-s)/u+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=ge.workingColorSpace){return ge.fromWorkingColorSpace(_n.copy(this),e),t.r=_n.r,t.g=_n.g,t.b=_n.b,t}getStyle(t=Bn){ge.fromWorkingColorSpace(_n.copy(this),t);const e=_n.r,n=_n.g,s=_n.b;return t!==Bn?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(es),this.setHSL(es.h+t,es.s+e,es.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(es),t.getHSL(ea);const n=Nl(es.h,ea.h,e),s=Nl(es.s,ea.s,e),o=Nl(es.l,ea.l,e);return this.setHSL(n,s,o),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){const e=this.r,n=this.g,s=this.b,o=t.elements;return this.r=o[0]*e+o[3]*n+o[6]*s,this.g=o[1]*e+o[4]*n+o[7]*s,this.b=o[2]*e+o[5]*n+o[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}}const _n=new de;de.NAMES=Nm;let OC=0;class Nr extends Jo{static get type(){return"Material"}get type(){return this.constructor.type}set type(t){}constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:OC++}),this.uuid=Cr(),this.name="",this.blending=No,this.side=ms,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Ac,this.blendDst=Rc,this.blendEquation=ks,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new de(0,0,0),this.blendAlpha=0,this.depthFunc=zo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=qd,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=uo,this.stencilZFail=uo,this.stencilZPass=uo,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(const e in t){const n=t[e];if(n===void 0){console.warn(`THREE.Material: parameter '${e}' has value of undefined.`);continue}const s=this[e];if(s===void 0){console.warn(`THREE.Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){const e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});const n={metadata:{version:4.6,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,this.name!==""&&(n.name=this.name),this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(n.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.shadowSide!==null&&(n.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),this.blending!==No&&(n.blending=this.blending),this.side!==ms&&(n.side=this.side),this.vertexColors===!0&&(n.vertexColors=!0),this.opacity<1&&(n.opacity=this.opacity),this.transparent===!0&&(n.transparent=!0),this.blendSrc!==Ac&&(n.blendSrc=this.blendSrc),this.blendDst!==Rc&&(n.blendDst=this.blendDst),this.blendEquation!==ks&&(n.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(n.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(n.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(n.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(n.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(n.blendAlpha=this.blendAlpha),this.depthFunc!==zo&&(n.depthFunc=this.depthFunc),this.depthTest===!1&&(n.depthTest=this.depthTest),this.depthWrite===!1&&(n.depthWrite=this.depthWrite),this.colorWrite===!1&&(n.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(n.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==qd&&(n.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(n.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(n.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==uo&&(n.stencilFail=this.stencilFail),this.stencilZFail!==uo&&(n.stencilZFail=this.stencilZFail),this.stencilZPass!==uo&&(n.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(n.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(n.rotation=this.rotation),this.polygonOffset===!0&&(n.polygonOffset=!0),this.polygonOffsetFactor!==0&&(n.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(n.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(n.linewidth=this.linewidth),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.dithering===!0&&(n.dithering=!0),this.alphaTest>0&&(n.alphaTest=this.alphaTest),this.alphaHash===!0&&(n.alphaHash=!0),this.alphaToCoverage===!0&&(n.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(n.premultipliedAlpha=!0),this.forceSinglePass===!0&&(n.forceSinglePass=!0),this.wireframe===!0&&(n.wireframe=!0),this.wireframeLinewidth>1&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(n.flatShading=!0),this.visible===!1&&(n.visible=!1),this.toneMapped===!1&&(n.toneMapped=!1),this.fog===!1&&(n.fog=!1),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(o){const a=[];for(const r in o){const l=o[r];delete l.metadata,a.push(l)}return a}if(e){const o=s(t.textures),a=s(t.images);o.length>0&&(n.textures=o),a.length>0&&(n.images=a)}return n}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;const e=t.clippingPlanes;let n=null;if(e!==null){const s=e.length;n=new Array(s);for(let o=0;o!==s;++o)n[o]=e[o].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}onBuild(){console.warn("Material: onBuild() has been removed.")}}class Kh extends Nr{static get type(){return"MeshBasicMaterial"}constructor(t){super(),this.isMeshBasicMaterial=!0,this.color=new de(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ei,this.combine=pm,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}}const qe=new et,na=new ve;class Si{constructor(t,e,n=!1){if(Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=Xd,this.updateRanges=[],this.gpuType=Oi,this.version=0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,o=this.itemSize;s<o;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)na.fromBufferAttribute(this,e),na.applyMatrix3(t),this.setXY(e,na.x,na.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)qe.fromBufferAttribute(this,e),qe.applyMatrix3(t),this.setXYZ(e,qe.x,qe.y,qe.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)qe.fromBufferAttribute(this,e),qe.applyMatrix4(t),this.setXYZ(e,qe.x,qe.y,qe.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)qe.fromBufferAttribute(this,e),qe.applyNormalMatrix(t),this.setXYZ(e,qe.x,qe.y,qe.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)qe.fromBufferAttribute(this,e),qe.transformDirection(t),this.setXYZ(e,qe.x,qe.y,qe.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=lr(n,this.array)),n}setComponent(t,e,n){return this.normalized&&(n=Rn(n,this.array)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=lr(e,this.array)),e}setX(t,e){return this.normalized&&(e=Rn(e,this.array)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=lr(e,this.array)),e}setY(t,e){return this.normalized&&(e=Rn(e,this.array)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=lr(e,this.array)),e}setZ(t,e){return this.normalized&&(e=Rn(e,this.array)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=lr(e,this.array)),e}setW(t,e){return this.normalized&&(e=Rn(e,this.array)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=Rn(e,this.array),n=Rn(n,this.array)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=Rn(e,this.array),n=Rn(n,this.array),s=Rn(s,this.array)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,o){return t*=this.itemSize,this.normalized&&(e=Rn(e,this.array),n=Rn(n,this.array),s=Rn(s,this.array),o=Rn(o,this.array)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=o,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){const t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(t.name=this.name),this.usage!==Xd&&(t.usage=this.usage),t}}class Dm extends Si{constructor(t,e,n){super(new Uint16Array(t),e,n)}}class Im extends Si{constructor(t,e,n){super(new Uint32Array(t),e,n)}}class wi extends Si{constructor(t,e,n){super(new Float32Array(t),e,n)}}let BC=0;const $n=new He,Kl=new fn,Mo=new et,kn=new Lr,dr=new Lr,cn=new et;class _s extends Jo{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:BC++}),this.uuid=Cr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Rm(t)?Im:Dm)(t,1):this.index=t,this}setIndirect(t){return this.indirect=t,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){const e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);const n=this.attributes.normal;if(n!==void 0){const o=new ne().getNormalMatrix(t);n.applyNormalMatrix(o),n.needsUpdate=!0}const s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(t){return $n.makeRotationFromQuaternion(t),this.applyMatrix4($n),this}rotateX(t){return $n.makeRotationX(t),this.applyMatrix4($n),this}rotateY(t){return $n.makeRotationY(t),this.applyMatrix4($n),this}rotateZ(t){return $n.makeRotationZ(t),this.applyMatrix4($n),this}translate(t,e,n){return $n.makeTranslation(t,e,n),this.applyMatrix4($n),this}scale(t,e,n){return $n.makeScale(t,e,n),this.applyMatrix4($n),this}lookAt(t){return Kl.lookAt(t),Kl.updateMatrix(),this.applyMatrix4(Kl.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Mo).negate(),this.translate(Mo.x,Mo.y,Mo.z),this}setFromPoints(t){const e=this.getAttribute("position");if(e===void 0){const n=[];for(let s=0,o=t.length;s<o;s++){const a=t[s];n.push(a.x,a.y,a.z||0)}this.setAttribute("position",new wi(n,3))}else{for(let n=0,s=e.count;n<s;n++){const o=t[n];e.setXYZ(n,o.x,o.y,o.z||0)}t.length>e.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Lr);const t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new et(-1/0,-1/0,-1/0),new et(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){const o=e[n];kn.setFromBufferAttribute(o),this.morphTargetsRelative?(cn.addVectors(this.boundingBox.min,kn.min),this.boundingBox.expandByPoint(cn),cn.addVectors(this.boundingBox.max,kn.max),this.boundingBox.expandByPoint(cn)):(this.boundingBox.expandByPoint(kn.min),this.boundingBox.expandByPoint(kn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new jh);const t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new et,1/0);return}if(t){const n=this.boundingSphere.center;if(kn.setFromBufferAttribute(t),e)for(let o=0,a=e.length;o<a;o++){const r=e[o];dr.setFromBufferAttribute(r),this.morphTargetsRelative?(cn.addVectors(kn.min,dr.min),kn.expandByPoint(cn),cn.addVectors(kn.max,dr.max),kn.expandByPoint(cn)):(kn.expandByPoint(dr.min),kn.expandByPoint(dr.max))}kn.getCenter(n);let s=0;for(let o=0,a=t.count;o<a;o++)cn.fromBufferAttribute(t,o),s=Math.max(s,n.distanceToSquared(cn));if(e)for(let o=0,a=e.length;o<a;o++){const r=e[o],l=this.morphTargetsRelative;for(let c=0,h=r.count;c<h;c++)cn.fromBufferAttribute(r,c),l&&(Mo.fromBufferAttribute(t,c),cn.add(Mo)),s=Math.max(s,n.distanceToSquared(cn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){const t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}const n=e.position,s=e.normal,o=e.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new Si(new Float32Array(4*n.count),4));const a=this.getAttribute("tangent"),r=[],l=[];for(let D=0;D<n.count;D++)r[D]=new et,l[D]=new et;const c=new et,h=new et,u=new et,d=new ve,p=new ve,_=new ve,g=new et,m=new et;function f(D,E,b){c.fromBufferAttribute(n,D),h.fromBufferAttribute(n,E),u.fromBufferAttribute(n,b),d.fromBufferAttribute(o,D),p.fromBufferAttribute(o,E),_.fromBufferAttribute(o,b),h.sub(c),u.sub(c),p.sub(d),_.sub(d);const R=1/(p.x*_.y-_.x*p.y);isFinite(R)&&(g.copy(h).multiplyScalar(_.y).addScaledVector(u,-p.y).multiplyScalar(R),m.copy(u).multiplyScalar(p.x).addScaledVector(h,-_.x).multiplyScalar(R),r[D].add(g),r[E].add(g),r[b].add(g),l[D].add(m),l[E].add(m),l[b].add(m))}let M=this.groups;M.length===0&&(M=[{start:0,count:t.count}]);for(let D=0,E=M.length;D<E;++D){const b=M[D],R=b.start,H=b.count;for(let O=R,q=R+H;O<q;O+=3)f(t.getX(O+0),t.getX(O+1),t.getX(O+2))}const S=new et,x=new et,F=new et,L=new et;function A(D){F.fromBufferAttribute(s,D),L.copy(F);const E=r[D];S.copy(E),S.sub(F.multiplyScalar(F.dot(E))).normalize(),x.crossVectors(L,E);const R=x.dot(l[D])<0?-1:1;a.setXYZW(D,S.x,S.y,S.z,R)}for(let D=0,E=M.length;D<E;++D){const b=M[D],R=b.start,H=b.count;for(let O=R,q=R+H;O<q;O+=3)A(t.getX(O+0)),A(t.getX(O+1)),A(t.getX(O+2))}}computeVertexNormals(){const t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0)n=new Si(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let d=0,p=n.count;d<p;d++)n.setXYZ(d,0,0,0);const s=new et,o=new et,a=new et,r=new et,l=new et,c=new et,h=new et,u=new et;if(t)for(let d=0,p=t.count;d<p;d+=3){const _=t.getX(d+0),g=t.getX(d+1),m=t.getX(d+2);s.fromBufferAttribute(e,_),o.fromBufferAttribute(e,g),a.fromBufferAttribute(e,m),h.subVectors(a,o),u.subVectors(s,o),h.cross(u),r.fromBufferAttribute(n,_),l.fromBufferAttribute(n,g),c.fromBufferAttribute(n,m),r.add(h),l.add(h),c.add(h),n.setXYZ(_,r.x,r.y,r.z),n.setXYZ(g,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let d=0,p=e.count;d<p;d+=3)s.fromBufferAttribute(e,d+0),o.fromBufferAttribute(e,d+1),a.fromBufferAttribute(e,d+2),h.subVectors(a,o),u.subVectors(s,o),h.cross(u),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){const t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)cn.fromBufferAttribute(t,e),cn.normalize(),t.setXYZ(e,cn.x,cn.y,cn.z)}toNonIndexed(){function t(r,l){const c=r.array,h=r.itemSize,u=r.normalized,d=new c.constructor(l.length*h);let p=0,_=0;for(let g=0,m=l.length;g<m;g++){r.isInterleavedBufferAttribute?p=l[g]*r.data.stride+r.offset:p=l[g]*h;for(let f=0;f<h;f++)d[_++]=c[p++]}return new Si(d,h,u)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;const e=new _s,n=this.index.array,s=this.attributes;for(const r in s){const l=s[r],c=t(l,n);e.setAttribute(r,c)}const o=this.morphAttributes;for(const r in o){const l=[],c=o[r];for(let h=0,u=c.length;h<u;h++){const d=c[h],p=t(d,n);l.push(p)}e.morphAttributes[r]=l}e.morphTargetsRelative=this.morphTargetsRelative;const a=this.groups;for(let r=0,l=a.length;r<l;r++){const c=a[r];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){const t={metadata:{version:4.6,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.type,this.name!==""&&(t.name=this.name),Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0){const l=this.parameters;for(const c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};const e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});const n=this.attributes;for(const l in n){const c=n[l];t.data.attributes[l]=c.toJSON(t.data)}const s={};let o=!1;for(const l in this.morphAttributes){const c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){const p=c[u];h.push(p.toJSON(t.data))}h.length>0&&(s[l]=h,o=!0)}o&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);const a=this.groups;a.length>0&&(t.data.groups=JSON.parse(JSON.stringify(a)));const r=this.boundingSphere;return r!==null&&(t.data.boundingSphere={center:r.center.toArray(),radius:r.radius}),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;const e={};this.name=t.name;const n=t.index;n!==null&&this.setIndex(n.clone(e));const s=t.attributes;for(const c in s){const h=s[c];this.setAttribute(c,h.clone(e))}const o=t.morphAttributes;for(const c in o){const h=[],u=o[c];for(let d=0,p=u.length;d<p;d++)h.push(u[d].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;const a=t.groups;for(let c=0,h=a.length;c<h;c++){const u=a[c];this.addGroup(u.start,u.count,u.materialIndex)}const r=t.boundingBox;r!==null&&(this.boundingBox=r.clone());const l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}}const uf=new He,Ts=new Lm,ia=new jh,df=new et,sa=new et,oa=new et,ra=new et,Zl=new et,aa=new et,ff=new et,la=new et;class dn extends fn{constructor(t=new _s,e=new Kh){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=t.morphTargetInfluences.slice()),t.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary)),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){const e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){const s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let o=0,a=s.length;o<a;o++){const r=s[o].name||String(o);this.morphTargetInfluences.push(0),this.morphTargetDictionary[r]=o}}}}getVertexPosition(t,e){const n=this.geometry,s=n.attributes.position,o=n.morphAttributes.position,a=n.morphTargetsRelative;e.fromBufferAttribute(s,t);const r=this.morphTargetInfluences;if(o&&r){aa.set(0,0,0);for(let l=0,c=o.length;l<c;l++){const h=r[l],u=o[l];h!==0&&(Zl.fromBufferAttribute(u,t),a?aa.addScaledVector(Zl,h):aa.addScaledVector(Zl.sub(e),h))}e.add(aa)}return e}raycast(t,e){const n=this.geometry,s=this.material,o=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),ia.copy(n.boundingSphere),ia.applyMatrix4(o),Ts.copy(t.ray).recast(t.near),!(ia.containsPoint(Ts.origin)===!1&&(Ts.intersectSphere(ia,df)===null||Ts.origin.distanceToSquared(df)>(t.far-t.near)**2))&&(uf.copy(o).invert(),Ts.copy(t.ray).applyMatrix4(uf),!(n.boundingBox!==null&&Ts.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,Ts)))}_computeIntersections(t,e,n){let s;const o=this.geometry,a=this.material,r=o.index,l=o.attributes.position,c=o.attributes.uv,h=o.attributes.uv1,u=o.attributes.normal,d=o.groups,p=o.drawRange;if(r!==null)if(Array.isArray(a))for(let _=0,g=d.length;_<g;_++){const m=d[_],f=a[m.materialIndex],M=Math.max(m.start,p.start),S=Math.min(r.count,Math.min(m.start+m.count,p.start+p.count));for(let x=M,F=S;x<F;x+=3){const L=r.getX(x),A=r.getX(x+1),D=r.getX(x+2);s=ca(this,f,t,n,c,h,u,L,A,D),s&&(s.faceIndex=Math.floor(x/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{const _=Math.max(0,p.start),g=Math.min(r.count,p.start+p.count);for(let m=_,f=g;m<f;m+=3){const M=r.getX(m),S=r.getX(m+1),x=r.getX(m+2);s=ca(this,a,t,n,c,h,u,M,S,x),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(a))for(let _=0,g=d.length;_<g;_++){const m=d[_],f=a[m.materialIndex],M=Math.max(m.start,p.start),S=Math.min(l.count,Math.min(m.start+m.count,p.start+p.count));for(let x=M,F=S;x<F;x+=3){const L=x,A=x+1,D=x+2;s=ca(this,f,t,n,c,h,u,L,A,D),s&&(s.faceIndex=Math.floor(x/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{const _=Math.max(0,p.start),g=Math.min(l.count,p.start+p.count);for(let m=_,f=g;m<f;m+=3){const M=m,S=m+1,x=m+2;s=ca(this,a,t,n,c,h,u,M,S,x),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}}function zC(i,t,e,n,s,o,a,r){let l;if(t.side===Pn?l=n.intersectTriangle(a,o,s,!0,r):l=n.intersectTriangle(s,o,a,t.side===ms,r),l===null)return null;la.copy(r),la.applyMatrix4(i.matrixWorld);const c=e.ray.origin.distanceTo(la);return c<e.near||c>e.far?null:{distance:c,point:la.clone(),object:i}}function ca(i,t,e,n,s,o,a,r,l,c){i.getVertexPosition(r,sa),i.getVertexPosition(l,oa),i.getVertexPosition(c,ra);const h=zC(i,t,e,n,sa,oa,ra,ff);if(h){const u=new et;ai.getBarycoord(ff,sa,oa,ra,u),s&&(h.uv=ai.getInterpolatedAttribute(s,r,l,c,u,new ve)),o&&(h.uv1=ai.getInterpolatedAttribute(o,r,l,c,u,new ve)),a&&(h.normal=ai.getInterpolatedAttribute(a,r,l,c,u,new et),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));const d={a:r,b:l,c,normal:new et,materialIndex:0};ai.getNormal(sa,oa,ra,d.normal),h.face=d,h.barycoord=u}return h}class Ys extends _s{constructor(t=1,e=1,n=1,s=1,o=1,a=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:o,depthSegments:a};const r=this;s=Math.floor(s),o=Math.floor(o),a=Math.floor(a);const l=[],c=[],h=[],u=[];let d=0,p=0;_("z","y","x",-1,-1,n,e,t,a,o,0),_("z","y","x",1,-1,n,e,-t,a,o,1),_("x","z","y",1,1,t,n,e,s,a,2),_("x","z","y",1,-1,t,n,-e,s,a,3),_("x","y","z",1,-1,t,e,n,s,o,4),_("x","y","z",-1,-1,t,e,-n,s,o,5),this.setIndex(l),this.setAttribute("position",new wi(c,3)),this.setAttribute("normal",new wi(h,3)),this.setAttribute("uv",new wi(u,2));function _(g,m,f,M,S,x,F,L,A,D,E){const b=x/A,R=F/D,H=x/2,O=F/2,q=L/2,$=A+1,X=D+1;let j=0,Q=0;const at=new et;for(let lt=0;lt<X;lt++){const gt=lt*R-O;for(let xt=0;xt<$;xt++){const mt=xt*b-H;at[g]=mt*M,at[m]=gt*S,at[f]=q,c.push(at.x,at.y,at.z),at[g]=0,at[m]=0,at[f]=L>0?1:-1,h.push(at.x,at.y,at.z),u.push(xt/A),u.push(1-lt/D),j+=1}}for(let lt=0;lt<D;lt++)for(let gt=0;gt<A;gt++){const xt=d+gt+$*lt,mt=d+gt+$*(lt+1),ot=d+(gt+1)+$*(lt+1),ut=d+(gt+1)+$*lt;l.push(xt,mt,ut),l.push(mt,ot,ut),Q+=6}r.addGroup(p,Q,E),p+=Q,d+=j}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new Ys(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}}function $o(i){const t={};for(const e in i){t[e]={};for(const n in i[e]){const s=i[e][n];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone():Array.isArray(s)?t[e][n]=s.slice():t[e][n]=s}}return t}function Sn(i){const t={};for(let e=0;e<i.length;e++){const n=$o(i[e]);for(const s in n)t[s]=n[s]}return t}function HC(i){const t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function Um(i){const t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:ge.workingColorSpace}const VC={clone:$o,merge:Sn};var GC=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,WC=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`;class gs extends Nr{static get type(){return"ShaderMaterial"}constructor(t){super(),this.isShaderMaterial=!0,this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=GC,this.fragmentShader=WC,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=$o(t.uniforms),this.uniformsGroups=HC(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this}toJSON(t){const e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(const s in this.uniforms){const a=this.uniforms[s].value;a&&a.isTexture?e.uniforms[s]={type:"t",value:a.toJSON(t).uuid}:a&&a.isColor?e.uniforms[s]={type:"c",value:a.getHex()}:a&&a.isVector2?e.uniforms[s]={type:"v2",value:a.toArray()}:a&&a.isVector3?e.uniforms[s]={type:"v3",value:a.toArray()}:a&&a.isVector4?e.uniforms[s]={type:"v4",value:a.toArray()}:a&&a.isMatrix3?e.uniforms[s]={type:"m3",value:a.toArray()}:a&&a.isMatrix4?e.uniforms[s]={type:"m4",value:a.toArray()}:e.uniforms[s]={value:a}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;const n={};for(const s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}}class km extends fn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new He,this.projectionMatrix=new He,this.projectionMatrixInverse=new He,this.coordinateSystem=Bi}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(t,e){super.updateWorldMatrix(t,e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}}const ns=new et,pf=new ve,mf=new ve;class Yn extends km{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){const e=.5*this.getFilmHeight()/t;this.fov=uh*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){const t=Math.tan(Ll*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return uh*2*Math.atan(Math.tan(Ll*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){ns.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(ns.x,ns.y).multiplyScalar(-t/ns.z),ns.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(ns.x,ns.y).multiplyScalar(-t/ns.z)}getViewSize(t,e){return this.getViewBounds(t,pf,mf),e.subVectors(mf,pf)}setViewOffset(t,e,n,s,o,a){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=o,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const t=this.near;let e=t*Math.tan(Ll*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,o=-.5*s;const a=this.view;if(this.view!==null&&this.view.enabled){const l=a.fullWidth,c=a.fullHeight;o+=a.offsetX*s/l,e-=a.offsetY*n/c,s*=a.width/l,n*=a.height/c}const r=this.filmOffset;r!==0&&(o+=t*r/this.getFilmWidth()),this.projectionMatrix.makePerspective(o,o+s,e,e-n,t,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){const e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}}const So=-90,wo=1;class $C extends fn{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;const s=new Yn(So,wo,t,e);s.layers=this.layers,this.add(s);const o=new Yn(So,wo,t,e);o.layers=this.layers,this.add(o);const a=new Yn(So,wo,t,e);a.layers=this.layers,this.add(a);const r=new Yn(So,wo,t,e);r.layers=this.layers,this.add(r);const l=new Yn(So,wo,t,e);l.layers=this.layers,this.add(l);const c=new Yn(So,wo,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){const t=this.coordinateSystem,e=this.children.concat(),[n,s,o,a,r,l]=e;for(const c of e)this.remove(c);if(t===Bi)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),o.up.set(0,0,-1),o.lookAt(0,1,0),a.up.set(0,0,1),a.lookAt(0,-1,0),r.up.set(0,1,0),r.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===Oa)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),o.up.set(0,0,1),o.lookAt(0,1,0),a.up.set(0,0,-1),a.lookAt(0,-1,0),r.up.set(0,-1,0),r.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(const c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();const{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());const[o,a,r,l,c,h]=this.children,u=t.getRenderTarget(),d=t.getActiveCubeFace(),p=t.getActiveMipmapLevel(),_=t.xr.enabled;t.xr.enabled=!1;const g=n.texture.generateMipmaps;n.texture.generateMipmaps=!1,t.setRenderTarget(n,0,s),t.render(e,o),t.setRenderTarget(n,1,s),t.render(e,a),t.setRenderTarget(n,2,s),t.render(e,r),t.setRenderTarget(n,3,s),t.render(e,l),t.setRenderTarget(n,4,s),t.render(e,c),n.texture.generateMipmaps=g,t.setRenderTarget(n,5,s),t.render(e,h),t.setRenderTarget(u,d,p),t.xr.enabled=_,n.texture.needsPMREMUpdate=!0}}class Fm extends En{constructor(t,e,n,s,o,a,r,l,c,h){t=t!==void 0?t:[],e=e!==void 0?e:Ho,super(t,e,n,s,o,a,r,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}}class qC extends js{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;const n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new Fm(s,e.mapping,e.wrapS,e.wrapT,e.magFilter,e.minFilter,e.format,e.type,e.anisotropy,e.colorSpace),this.texture.isRenderTargetTexture=!0,this.texture.generateMipmaps=e.generateMipmaps!==void 0?e.generateMipmaps:!1,this.texture.minFilter=e.minFilter!==void 0?e.minFilter:bi}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;const n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Ys(5,5,5),o=new gs({name:"CubemapFromEquirect",uniforms:$o(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Pn,blending:cs});o.uniforms.tEquirect.value=e;const a=new dn(s,o),r=e.minFilter;return e.minFilter===Bs&&(e.minFilter=bi),new $C(1,10,this).update(t,a),e.minFilter=r,a.geometry.dispose(),a.material.dispose(),this}clear(t,e,n,s){const o=t.getRenderTarget();for(let a=0;a<6;a++)t.setRenderTarget(this,a),t.clear(e,n,s);t.setRenderTarget(o)}}const Jl=new et,XC=new et,jC=new ne;class rs{constructor(t=new et(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){const s=Jl.subVectors(n,e).cross(XC.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){const t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e){const n=t.delta(Jl),s=this.normal.dot(n);if(s===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;const o=-(t.start.dot(this.normal)+this.constant)/s;return o<0||o>1?null:e.copy(t.start).addScaledVector(n,o)}intersectsLine(t){const e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){const n=e||jC.getNormalMatrix(t),s=this.coplanarPoint(Jl).applyMatrix4(t),o=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(o),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}}const As=new jh,ha=new et;class Zh{constructor(t=new rs,e=new rs,n=new rs,s=new rs,o=new rs,a=new rs){this.planes=[t,e,n,s,o,a]}set(t,e,n,s,o,a){const r=this.planes;return r[0].copy(t),r[1].copy(e),r[2].copy(n),r[3].copy(s),r[4].copy(o),r[5].copy(a),this}copy(t){const e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=Bi){const n=this.planes,s=t.elements,o=s[0],a=s[1],r=s[2],l=s[3],c=s[4],h=s[5],u=s[6],d=s[7],p=s[8],_=s[9],g=s[10],m=s[11],f=s[12],M=s[13],S=s[14],x=s[15];if(n[0].setComponents(l-o,d-c,m-p,x-f).normalize(),n[1].setComponents(l+o,d+c,m+p,x+f).normalize(),n[2].setComponents(l+a,d+h,m+_,x+M).normalize(),n[3].setComponents(l-a,d-h,m-_,x-M).normalize(),n[4].setComponents(l-r,d-u,m-g,x-S).normalize(),e===Bi)n[5].setComponents(l+r,d+u,m+g,x+S).normalize();else if(e===Oa)n[5].setComponents(r,u,g,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),As.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{const e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),As.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(As)}intersectsSprite(t){return As.center.set(0,0,0),As.radius=.7071067811865476,As.applyMatrix4(t.matrixWorld),this.intersectsSphere(As)}intersectsSphere(t){const e=this.planes,n=t.center,s=-t.radius;for(let o=0;o<6;o++)if(e[o].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){const e=this.planes;for(let n=0;n<6;n++){const s=e[n];if(ha.x=s.normal.x>0?t.max.x:t.min.x,ha.y=s.normal.y>0?t.max.y:t.min.y,ha.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(ha)<0)return!1}return!0}containsPoint(t){const e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}}function Om(){let i=null,t=!1,e=null,n=null;function s(o,a){e(o,a),n=i.requestAnimationFrame(s)}return{start:function(){t!==!0&&e!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(o){e=o},setContext:function(o){i=o}}}function YC(i){const t=new WeakMap;function e(r,l){const c=r.array,h=r.usage,u=c.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,c,h),r.onUploadCallback();let p;if(c instanceof Float32Array)p=i.FLOAT;else if(c instanceof Uint16Array)r.isFloat16BufferAttribute?p=i.HALF_FLOAT:p=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=i.SHORT;else if(c instanceof Uint32Array)p=i.UNSIGNED_INT;else if(c instanceof Int32Array)p=i.INT;else if(c instanceof Int8Array)p=i.BYTE;else if(c instanceof Uint8Array)p=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:r.version,size:u}}function n(r,l,c){const h=l.array,u=l.updateRanges;if(i.bindBuffer(c,r),u.length===0)i.bufferSubData(c,0,h);else{u.sort((p,_)=>p.start-_.start);let d=0;for(let p=1;p<u.length;p++){const _=u[d],g=u[p];g.start<=_.start+_.count+1?_.count=Math.max(_.count,g.start+g.count-_.start):(++d,u[d]=g)}u.length=d+1;for(let p=0,_=u.length;p<_;p++){const g=u[p];i.bufferSubData(c,g.start*h.BYTES_PER_ELEMENT,h,g.start,g.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(r){return r.isInterleavedBufferAttribute&&(r=r.data),t.get(r)}function o(r){r.isInterleavedBufferAttribute&&(r=r.data);const l=t.get(r);l&&(i.deleteBuffer(l.buffer),t.delete(r))}function a(r,l){if(r.isInterleavedBufferAttribute&&(r=r.data),r.isGLBufferAttribute){const h=t.get(r);(!h||h.version<r.version)&&t.set(r,{buffer:r.buffer,type:r.type,bytesPerElement:r.elementSize,version:r.version});return}const c=t.get(r);if(c===void 0)t.set(r,e(r,l));else if(c.version<r.version){if(c.size!==r.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,r,l),c.version=r.version}}return{get:s,remove:o,update:a}}class Dr extends _s{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};const o=t/2,a=e/2,r=Math.floor(n),l=Math.floor(s),c=r+1,h=l+1,u=t/r,d=e/l,p=[],_=[],g=[],m=[];for(let f=0;f<h;f++){const M=f*d-a;for(let S=0;S<c;S++){const x=S*u-o;_.push(x,-M,0),g.push(0,0,1),m.push(S/r),m.push(1-f/l)}}for(let f=0;f<l;f++)for(let M=0;M<r;M++){const S=M+c*f,x=M+c*(f+1),F=M+1+c*(f+1),L=M+1+c*f;p.push(S,x,L),p.push(x,F,L)}this.setIndex(p),this.setAttribute("position",new wi(_,3)),this.setAttribute("normal",new wi(g,3)),this.setAttribute("uv",new wi(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new Dr(t.width,t.height,t.widthSegments,t.heightSegments)}}var KC=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,ZC=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,JC=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,QC=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,t2=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,e2=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,n2=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,i2=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,s2=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec3 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 ).rgb;
	}
#endif`,o2=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,r2=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,a2=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,l2=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,c2=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,h2=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,u2=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,d2=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,f2=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,p2=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,m2=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,g2=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,_2=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,v2=`#if defined( USE_COLOR_ALPHA )
	vColor = vec4( 1.0 );
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec3( 1.0 );
#endif
#ifdef USE_COLOR
	vColor *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.xyz *= instanceColor.xyz;
#endif
#ifdef USE_BATCHING_COLOR
	vec3 batchingColor = getBatchingColor( getIndirectIndex( gl_DrawID ) );
	vColor.xyz *= batchingColor.xyz;
#endif`,x2=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
vec3 inverseTransformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( vec4( dir, 0.0 ) * matrix ).xyz );
}
mat3 transposeMat3( const in mat3 m ) {
	mat3 tmp;
	tmp[ 0 ] = vec3( m[ 0 ].x, m[ 1 ].x, m[ 2 ].x );
	tmp[ 1 ] = vec3( m[ 0 ].y, m[ 1 ].y, m[ 2 ].y );
	tmp[ 2 ] = vec3( m[ 0 ].z, m[ 1 ].z, m[ 2 ].z );
	return tmp;
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,b2=`#ifdef ENVMAP_TYPE_CUBE_UV
	#define cubeUV_minMipLevel 4.0
	#define cubeUV_minTileSize 16.0
	float getFace( vec3 direction ) {
		vec3 absDirection = abs( direction );
		float face = - 1.0;
		if ( absDirection.x > absDirection.z ) {
			if ( absDirection.x > absDirection.y )
				face = direction.x > 0.0 ? 0.0 : 3.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		} else {
			if ( absDirection.z > absDirection.y )
				face = direction.z > 0.0 ? 2.0 : 5.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		}
		return face;
	}
	vec2 getUV( vec3 direction, float face ) {
		vec2 uv;
		if ( face == 0.0 ) {
			uv = vec2( direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 1.0 ) {
			uv = vec2( - direction.x, - direction.z ) / abs( direction.y );
		} else if ( face == 2.0 ) {
			uv = vec2( - direction.x, direction.y ) / abs( direction.z );
		} else if ( face == 3.0 ) {
			uv = vec2( - direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 4.0 ) {
			uv = vec2( - direction.x, direction.z ) / abs( direction.y );
		} else {
			uv = vec2( direction.x, direction.y ) / abs( direction.z );
		}
		return 0.5 * ( uv + 1.0 );
	}
	vec3 bilinearCubeUV( sampler2D envMap, vec3 direction, float mipInt ) {
		float face = getFace( direction );
		float filterInt = max( cubeUV_minMipLevel - mipInt, 0.0 );
		mipInt = max( mipInt, cubeUV_minMipLevel );
		float faceSize = exp2( mipInt );
		highp vec2 uv = getUV( direction, face ) * ( faceSize - 2.0 ) + 1.0;
		if ( face > 2.0 ) {
			uv.y += faceSize;
			face -= 3.0;
		}
		uv.x += face * faceSize;
		uv.x += filterInt * 3.0 * cubeUV_minTileSize;
		uv.y += 4.0 * ( exp2( CUBEUV_MAX_MIP ) - faceSize );
		uv.x *= CUBEUV_TEXEL_WIDTH;
		uv.y *= CUBEUV_TEXEL_HEIGHT;
		#ifdef texture2DGradEXT
			return texture2DGradEXT( envMap, uv, vec2( 0.0 ), vec2( 0.0 ) ).rgb;
		#else
			return texture2D( envMap, uv ).rgb;
		#endif
	}
	#define cubeUV_r0 1.0
	#define cubeUV_m0 - 2.0
	#define cubeUV_r1 0.8
	#define cubeUV_m1 - 1.0
	#define cubeUV_r4 0.4
	#define cubeUV_m4 2.0
	#define cubeUV_r5 0.305
	#define cubeUV_m5 3.0
	#define cubeUV_r6 0.21
	#define cubeUV_m6 4.0
	float roughnessToMip( float roughness ) {
		float mip = 0.0;
		if ( roughness >= cubeUV_r1 ) {
			mip = ( cubeUV_r0 - roughness ) * ( cubeUV_m1 - cubeUV_m0 ) / ( cubeUV_r0 - cubeUV_r1 ) + cubeUV_m0;
		} else if ( roughness >= cubeUV_r4 ) {
			mip = ( cubeUV_r1 - roughness ) * ( cubeUV_m4 - cubeUV_m1 ) / ( cubeUV_r1 - cubeUV_r4 ) + cubeUV_m1;
		} else if ( roughness >= cubeUV_r5 ) {
			mip = ( cubeUV_r4 - roughness ) * ( cubeUV_m5 - cubeUV_m4 ) / ( cubeUV_r4 - cubeUV_r5 ) + cubeUV_m4;
		} else if ( roughness >= cubeUV_r6 ) {
			mip = ( cubeUV_r5 - roughness ) * ( cubeUV_m6 - cubeUV_m5 ) / ( cubeUV_r5 - cubeUV_r6 ) + cubeUV_m5;
		} else {
			mip = - 2.0 * log2( 1.16 * roughness );		}
		return mip;
	}
	vec4 textureCubeUV( sampler2D envMap, vec3 sampleDir, float roughness ) {
		float mip = clamp( roughnessToMip( roughness ), cubeUV_m0, CUBEUV_MAX_MIP );
		float mipF = fract( mip );
		float mipInt = floor( mip );
		vec3 color0 = bilinearCubeUV( envMap, sampleDir, mipInt );
		if ( mipF == 0.0 ) {
			return vec4( color0, 1.0 );
		} else {
			vec3 color1 = bilinearCubeUV( envMap, sampleDir, mipInt + 1.0 );
			return vec4( mix( color0, color1, mipF ), 1.0 );
		}
	}
#endif`,y2=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
	#ifdef FLIP_SIDED
		transformedTangent = - transformedTangent;
	#endif
#endif`,M2=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,S2=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,w2=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,E2=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,T2="gl_FragColor = linearToOutputTexel( gl_FragColor );",A2=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,R2=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * vec3( flipEnvMap * reflectVec.x, reflectVec.yz ) );
	#else
		vec4 envColor = vec4( 0.0 );
	#endif
	#ifdef ENVMAP_BLENDING_MULTIPLY
		outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_MIX )
		outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_ADD )
		outgoingLight += envColor.xyz * specularStrength * reflectivity;
	#endif
#endif`,C2=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,P2=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,L2=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,N2=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,D2=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,I2=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,U2=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,k2=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,F2=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,O2=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,B2=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,z2=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,H2=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif`,V2=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * worldNormal, 1.0 );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, roughness * roughness) );
			reflectVec = inverseTransformDirection( reflectVec, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * reflectVec, roughness );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_CUBE_UV
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
#endif`,G2=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,W2=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,$2=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,q2=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,X2=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb * ( 1.0 - metalnessFactor );
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.0525 );material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = mix( min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = mix( vec3( 0.04 ), diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.0525 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.07, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,j2=`struct PhysicalMaterial {
	vec3 diffuseColor;
	float roughness;
	vec3 specularColor;
	float specularF90;
	float dispersion;
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		float v = 0.5 / ( gv + gl );
		return saturate(v);
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = material.clearcoatRoughness;
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColor;
	float f90 = material.specularF90;
	float roughness = material.roughness;
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float V = V_GGX_SmithCorrelated_Anisotropic( material.alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( material.alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transposeMat3( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float a = roughness < 0.25 ? -339.2 * r2 + 161.4 * roughness - 25.9 : -8.48 * r2 + 14.3 * roughness - 9.95;
	float b = roughness < 0.25 ? 44.0 * r2 - 23.7 * roughness + 3.26 : 1.97 * r2 - 3.27 * roughness + 0.72;
	float DG = exp( a * dotNV + b ) + ( roughness < 0.25 ? 0.0 : 0.1 * ( roughness - 0.25 ) );
	return saturate( DG * RECIPROCAL_PI );
}
vec2 DFGApprox( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	const vec4 c0 = vec4( - 1, - 0.0275, - 0.572, 0.022 );
	const vec4 c1 = vec4( 1, 0.0425, 1.04, - 0.04 );
	vec4 r = roughness * c0 + c1;
	float a004 = min( r.x * r.x, exp2( - 9.28 * dotNV ) ) * r.x + r.y;
	vec2 fab = vec2( - 1.04, 1.04 ) * a004 + r.zw;
	return fab;
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColor * t2.x + ( vec3( 1.0 ) - material.specularColor ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseColor * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
	#endif
	reflectedLight.directSpecular += irradiance * BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
	#endif
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.iridescence, material.iridescenceFresnel, material.roughness, singleScattering, multiScattering );
	#else
		computeMultiscattering( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.roughness, singleScattering, multiScattering );
	#endif
	vec3 totalScattering = singleScattering + multiScattering;
	vec3 diffuse = material.diffuseColor * ( 1.0 - max( max( totalScattering.r, totalScattering.g ), totalScattering.b ) );
	reflectedLight.indirectSpecular += radiance * singleScattering;
	reflectedLight.indirectSpecular += multiScattering * cosineWeightedIrradiance;
	reflectedLight.indirectDiffuse += diffuse * cosineWeightedIrradiance;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Y2=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		material.iridescenceFresnel = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		material.iridescenceF0 = Schlick_to_F0( material.iridescenceFresnel, 1.0, dotNVi );
	}
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,K2=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD ) && defined( ENVMAP_TYPE_CUBE_UV )
		iblIrradiance += getIBLIrradiance( geometryNormal );
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		radiance += getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		radiance += getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Z2=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,J2=`#if defined( USE_LOGDEPTHBUF )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Q2=`#if defined( USE_LOGDEPTHBUF )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,tP=`#ifdef USE_LOGDEPTHBUF
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,eP=`#ifdef USE_LOGDEPTHBUF
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,nP=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,iP=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,sP=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,oP=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,rP=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,aP=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,lP=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,cP=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,hP=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,uP=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,dP=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,fP=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,pP=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,mP=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,gP=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,_P=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,vP=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,xP=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,bP=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,yP=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,MP=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,SP=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,wP=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return depth * ( near - far ) - near;
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return ( near * far ) / ( ( far - near ) * depth - far );
}`,EP=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,TP=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,AP=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,RP=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,CP=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,PP=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,LP=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform sampler2D pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	float texture2DCompare( sampler2D depths, vec2 uv, float compare ) {
		return step( compare, unpackRGBAToDepth( texture2D( depths, uv ) ) );
	}
	vec2 texture2DDistribution( sampler2D shadow, vec2 uv ) {
		return unpackRGBATo2Half( texture2D( shadow, uv ) );
	}
	float VSMShadow (sampler2D shadow, vec2 uv, float compare ){
		float occlusion = 1.0;
		vec2 distribution = texture2DDistribution( shadow, uv );
		float hard_shadow = step( compare , distribution.x );
		if (hard_shadow != 1.0 ) {
			float distance = compare - distribution.x ;
			float variance = max( 0.00000, distribution.y * distribution.y );
			float softness_probability = variance / (variance + distance * distance );			softness_probability = clamp( ( softness_probability - 0.3 ) / ( 0.95 - 0.3 ), 0.0, 1.0 );			occlusion = clamp( max( hard_shadow, softness_probability ), 0.0, 1.0 );
		}
		return occlusion;
	}
	float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
		float shadow = 1.0;
		shadowCoord.xyz /= shadowCoord.w;
		shadowCoord.z += shadowBias;
		bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
		bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
		if ( frustumTest ) {
		#if defined( SHADOWMAP_TYPE_PCF )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx0 = - texelSize.x * shadowRadius;
			float dy0 = - texelSize.y * shadowRadius;
			float dx1 = + texelSize.x * shadowRadius;
			float dy1 = + texelSize.y * shadowRadius;
			float dx2 = dx0 / 2.0;
			float dy2 = dy0 / 2.0;
			float dx3 = dx1 / 2.0;
			float dy3 = dy1 / 2.0;
			shadow = (
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy1 ), shadowCoord.z )
			) * ( 1.0 / 17.0 );
		#elif defined( SHADOWMAP_TYPE_PCF_SOFT )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx = texelSize.x;
			float dy = texelSize.y;
			vec2 uv = shadowCoord.xy;
			vec2 f = fract( uv * shadowMapSize + 0.5 );
			uv -= f * texelSize;
			shadow = (
				texture2DCompare( shadowMap, uv, shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( dx, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( 0.0, dy ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + texelSize, shadowCoord.z ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, 0.0 ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 0.0 ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, dy ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( 0.0, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 0.0, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( texture2DCompare( shadowMap, uv + vec2( dx, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( dx, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( mix( texture2DCompare( shadowMap, uv + vec2( -dx, -dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, -dy ), shadowCoord.z ),
						  f.x ),
					 mix( texture2DCompare( shadowMap, uv + vec2( -dx, 2.0 * dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 2.0 * dy ), shadowCoord.z ),
						  f.x ),
					 f.y )
			) * ( 1.0 / 9.0 );
		#elif defined( SHADOWMAP_TYPE_VSM )
			shadow = VSMShadow( shadowMap, shadowCoord.xy, shadowCoord.z );
		#else
			shadow = texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z );
		#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	vec2 cubeToUV( vec3 v, float texelSizeY ) {
		vec3 absV = abs( v );
		float scaleToCube = 1.0 / max( absV.x, max( absV.y, absV.z ) );
		absV *= scaleToCube;
		v *= scaleToCube * ( 1.0 - 2.0 * texelSizeY );
		vec2 planar = v.xy;
		float almostATexel = 1.5 * texelSizeY;
		float almostOne = 1.0 - almostATexel;
		if ( absV.z >= almostOne ) {
			if ( v.z > 0.0 )
				planar.x = 4.0 - v.x;
		} else if ( absV.x >= almostOne ) {
			float signX = sign( v.x );
			planar.x = v.z * signX + 2.0 * signX;
		} else if ( absV.y >= almostOne ) {
			float signY = sign( v.y );
			planar.x = v.x + 2.0 * signY + 2.0;
			planar.y = v.z * signY - 2.0;
		}
		return vec2( 0.125, 0.25 ) * planar + vec2( 0.375, 0.75 );
	}
	float getPointShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		
		float lightToPositionLength = length( lightToPosition );
		if ( lightToPositionLength - shadowCameraFar <= 0.0 && lightToPositionLength - shadowCameraNear >= 0.0 ) {
			float dp = ( lightToPositionLength - shadowCameraNear ) / ( shadowCameraFar - shadowCameraNear );			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			vec2 texelSize = vec2( 1.0 ) / ( shadowMapSize * vec2( 4.0, 2.0 ) );
			#if defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_PCF_SOFT ) || defined( SHADOWMAP_TYPE_VSM )
				vec2 offset = vec2( - 1, 1 ) * shadowRadius * texelSize.y;
				shadow = (
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxx, texelSize.y ), dp )
				) * ( 1.0 / 9.0 );
			#else
				shadow = texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp );
			#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
#endif`,NP=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,DP=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	vec3 shadowWorldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,IP=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,UP=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,kP=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,FP=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,OP=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,BP=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,zP=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,HP=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,VP=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,GP=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = inverseTransformDirection( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseColor, material.specularColor, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,WP=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
		
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
		
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		
		#else
		
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,$P=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,qP=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,XP=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,jP=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`;const YP=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,KP=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,ZP=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,JP=`#ifdef ENVMAP_TYPE_CUBE
	uniform samplerCube envMap;
#elif defined( ENVMAP_TYPE_CUBE_UV )
	uniform sampler2D envMap;
#endif
uniform float flipEnvMap;
uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <cube_uv_reflection_fragment>
void main() {
	#ifdef ENVMAP_TYPE_CUBE
		vec4 texColor = textureCube( envMap, backgroundRotation * vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) );
	#elif defined( ENVMAP_TYPE_CUBE_UV )
		vec4 texColor = textureCubeUV( envMap, backgroundRotation * vWorldDirection, backgroundBlurriness );
	#else
		vec4 texColor = vec4( 0.0, 0.0, 0.0, 1.0 );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,QP=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,tL=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,eL=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,nL=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	float fragCoordZ = 0.5 * vHighPrecisionZW[0] / vHighPrecisionZW[1] + 0.5;
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,iL=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,sL=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main () {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = packDepthToRGBA( dist );
}`,oL=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,rL=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,aL=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,lL=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,cL=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,hL=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,uL=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,dL=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,fL=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,pL=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,mL=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,gL=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <packing>
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( packNormalToRGB( normal ), diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,_L=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,vL=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,xL=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,bL=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <cube_uv_reflection_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
		float sheenEnergyComp = 1.0 - 0.157 * max3( material.sheenColor );
		outgoingLight = outgoingLight * sheenEnergyComp + sheenSpecularDirect + sheenSpecularIndirect;
	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,yL=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,ML=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,SL=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,wL=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,EL=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,TL=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <packing>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,AL=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,RL=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,se={alphahash_fragment:KC,alphahash_pars_fragment:ZC,alphamap_fragment:JC,alphamap_pars_fragment:QC,alphatest_fragment:t2,alphatest_pars_fragment:e2,aomap_fragment:n2,aomap_pars_fragment:i2,batching_pars_vertex:s2,batching_vertex:o2,begin_vertex:r2,beginnormal_vertex:a2,bsdfs:l2,iridescence_fragment:c2,bumpmap_pars_fragment:h2,clipping_planes_fragment:u2,clipping_planes_pars_fragment:d2,clipping_planes_pars_vertex:f2,clipping_planes_vertex:p2,color_fragment:m2,color_pars_fragment:g2,color_pars_vertex:_2,color_vertex:v2,common:x2,cube_uv_reflection_fragment:b2,defaultnormal_vertex:y2,displacementmap_pars_vertex:M2,displacementmap_vertex:S2,emissivemap_fragment:w2,emissivemap_pars_fragment:E2,colorspace_fragment:T2,colorspace_pars_fragment:A2,envmap_fragment:R2,envmap_common_pars_fragment:C2,envmap_pars_fragment:P2,envmap_pars_vertex:L2,envmap_physical_pars_fragment:V2,envmap_vertex:N2,fog_vertex:D2,fog_pars_vertex:I2,fog_fragment:U2,fog_pars_fragment:k2,gradientmap_pars_fragment:F2,lightmap_pars_fragment:O2,lights_lambert_fragment:B2,lights_lambert_pars_fragment:z2,lights_pars_begin:H2,lights_toon_fragment:G2,lights_toon_pars_fragment:W2,lights_phong_fragment:$2,lights_phong_pars_fragment:q2,lights_physical_fragment:X2,lights_physical_pars_fragment:j2,lights_fragment_begin:Y2,lights_fragment_maps:K2,lights_fragment_end:Z2,logdepthbuf_fragment:J2,logdepthbuf_pars_fragment:Q2,logdepthbuf_pars_vertex:tP,logdepthbuf_vertex:eP,map_fragment:nP,map_pars_fragment:iP,map_particle_fragment:sP,map_particle_pars_fragment:oP,metalnessmap_fragment:rP,metalnessmap_pars_fragment:aP,morphinstance_vertex:lP,morphcolor_vertex:cP,morphnormal_vertex:hP,morphtarget_pars_vertex:uP,morphtarget_vertex:dP,normal_fragment_begin:fP,normal_fragment_maps:pP,normal_pars_fragment:mP,normal_pars_vertex:gP,normal_vertex:_P,normalmap_pars_fragment:vP,clearcoat_normal_fragment_begin:xP,clearcoat_normal_fragment_maps:bP,clearcoat_pars_fragment:yP,iridescence_pars_fragment:MP,opaque_fragment:SP,packing:wP,premultiplied_alpha_fragment:EP,project_vertex:TP,dithering_fragment:AP,dithering_pars_fragment:RP,roughnessmap_fragment:CP,roughnessmap_pars_fragment:PP,shadowmap_pars_fragment:LP,shadowmap_pars_vertex:NP,shadowmap_vertex:DP,shadowmask_pars_fragment:IP,skinbase_vertex:UP,skinning_pars_vertex:kP,skinning_vertex:FP,skinnormal_vertex:OP,specularmap_fragment:BP,specularmap_pars_fragment:zP,tonemapping_fragment:HP,tonemapping_pars_fragment:VP,transmission_fragment:GP,transmission_pars_fragment:WP,uv_pars_fragment:$P,uv_pars_vertex:qP,uv_vertex:XP,worldpos_vertex:jP,background_vert:YP,background_frag:KP,backgroundCube_vert:ZP,backgroundCube_frag:JP,cube_vert:QP,cube_frag:tL,depth_vert:eL,depth_frag:nL,distanceRGBA_vert:iL,distanceRGBA_frag:sL,equirect_vert:oL,equirect_frag:rL,linedashed_vert:aL,linedashed_frag:lL,meshbasic_vert:cL,meshbasic_frag:hL,meshlambert_vert:uL,meshlambert_frag:dL,meshmatcap_vert:fL,meshmatcap_frag:pL,meshnormal_vert:mL,meshnormal_frag:gL,meshphong_vert:_L,meshphong_frag:vL,meshphysical_vert:xL,meshphysical_frag:bL,meshtoon_vert:yL,meshtoon_frag:ML,points_vert:SL,points_frag:wL,shadow_vert:EL,shadow_frag:TL,sprite_vert:AL,sprite_frag:RL},Tt={common:{diffuse:{value:new de(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ne},alphaMap:{value:null},alphaMapTransform:{value:new ne},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ne}},envmap:{envMap:{value:null},envMapRotation:{value:new ne},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ne}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ne}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ne},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ne},normalScale:{value:new ve(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ne},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ne}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ne}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ne}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new de(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new de(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ne},alphaTest:{value:0},uvTransform:{value:new ne}},sprite:{diffuse:{value:new de(16777215)},opacity:{value:1},center:{value:new ve(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ne},alphaMap:{value:null},alphaMapTransform:{value:new ne},alphaTest:{value:0}}},vi={basic:{uniforms:Sn([Tt.common,Tt.specularmap,Tt.envmap,Tt.aomap,Tt.lightmap,Tt.fog]),vertexShader:se.meshbasic_vert,fragmentShader:se.meshbasic_frag},lambert:{uniforms:Sn([Tt.common,Tt.specularmap,Tt.envmap,Tt.aomap,Tt.lightmap,Tt.emissivemap,Tt.bumpmap,Tt.normalmap,Tt.displacementmap,Tt.fog,Tt.lights,{emissive:{value:new de(0)}}]),vertexShader:se.meshlambert_vert,fragmentShader:se.meshlambert_frag},phong:{uniforms:Sn([Tt.common,Tt.specularmap,Tt.envmap,Tt.aomap,Tt.lightmap,Tt.emissivemap,Tt.bumpmap,Tt.normalmap,Tt.displacementmap,Tt.fog,Tt.lights,{emissive:{value:new de(0)},specular:{value:new de(1118481)},shininess:{value:30}}]),vertexShader:se.meshphong_vert,fragmentShader:se.meshphong_frag},standard:{uniforms:Sn([Tt.common,Tt.envmap,Tt.aomap,Tt.lightmap,Tt.emissivemap,Tt.bumpmap,Tt.normalmap,Tt.displacementmap,Tt.roughnessmap,Tt.metalnessmap,Tt.fog,Tt.lights,{emissive:{value:new de(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:se.meshphysical_vert,fragmentShader:se.meshphysical_frag},toon:{uniforms:Sn([Tt.common,Tt.aomap,Tt.lightmap,Tt.emissivemap,Tt.bumpmap,Tt.normalmap,Tt.displacementmap,Tt.gradientmap,Tt.fog,Tt.lights,{emissive:{value:new de(0)}}]),vertexShader:se.meshtoon_vert,fragmentShader:se.meshtoon_frag},matcap:{uniforms:Sn([Tt.common,Tt.bumpmap,Tt.normalmap,Tt.displacementmap,Tt.fog,{matcap:{value:null}}]),vertexShader:se.meshmatcap_vert,fragmentShader:se.meshmatcap_frag},points:{uniforms:Sn([Tt.points,Tt.fog]),vertexShader:se.points_vert,fragmentShader:se.points_frag},dashed:{uniforms:Sn([Tt.common,Tt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:se.linedashed_vert,fragmentShader:se.linedashed_frag},depth:{uniforms:Sn([Tt.common,Tt.displacementmap]),vertexShader:se.depth_vert,fragmentShader:se.depth_frag},normal:{uniforms:Sn([Tt.common,Tt.bumpmap,Tt.normalmap,Tt.displacementmap,{opacity:{value:1}}]),vertexShader:se.meshnormal_vert,fragmentShader:se.meshnormal_frag},sprite:{uniforms:Sn([Tt.sprite,Tt.fog]),vertexShader:se.sprite_vert,fragmentShader:se.sprite_frag},background:{uniforms:{uvTransform:{value:new ne},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:se.background_vert,fragmentShader:se.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ne}},vertexShader:se.backgroundCube_vert,fragmentShader:se.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:se.cube_vert,fragmentShader:se.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:se.equirect_vert,fragmentShader:se.equirect_frag},distanceRGBA:{uniforms:Sn([Tt.common,Tt.displacementmap,{referencePosition:{value:new et},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:se.distanceRGBA_vert,fragmentShader:se.distanceRGBA_frag},shadow:{uniforms:Sn([Tt.lights,Tt.fog,{color:{value:new de(0)},opacity:{value:1}}]),vertexShader:se.shadow_vert,fragmentShader:se.shadow_frag}};vi.physical={uniforms:Sn([vi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ne},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ne},clearcoatNormalScale:{value:new ve(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ne},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ne},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ne},sheen:{value:0},sheenColor:{value:new de(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ne},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ne},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ne},transmissionSamplerSize:{value:new ve},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ne},attenuationDistance:{value:0},attenuationColor:{value:new de(0)},specularColor:{value:new de(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ne},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ne},anisotropyVector:{value:new ve},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ne}}]),vertexShader:se.meshphysical_vert,fragmentShader:se.meshphysical_frag};const ua={r:0,b:0,g:0},Rs=new Ei,CL=new He;function PL(i,t,e,n,s,o,a){const r=new de(0);let l=o===!0?0:1,c,h,u=null,d=0,p=null;function _(M){let S=M.isScene===!0?M.background:null;return S&&S.isTexture&&(S=(M.backgroundBlurriness>0?e:t).get(S)),S}function g(M){let S=!1;const x=_(M);x===null?f(r,l):x&&x.isColor&&(f(x,1),S=!0);const F=i.xr.getEnvironmentBlendMode();F==="additive"?n.buffers.color.setClear(0,0,0,1,a):F==="alpha-blend"&&n.buffers.color.setClear(0,0,0,0,a),(i.autoClear||S)&&(n.buffers.depth.setTest(!0),n.buffers.depth.setMask(!0),n.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function m(M,S){const x=_(S);x&&(x.isCubeTexture||x.mapping===el)?(h===void 0&&(h=new dn(new Ys(1,1,1),new gs({name:"BackgroundCubeMaterial",uniforms:$o(vi.backgroundCube.uniforms),vertexShader:vi.backgroundCube.vertexShader,fragmentShader:vi.backgroundCube.fragmentShader,side:Pn,depthTest:!1,depthWrite:!1,fog:!1})),h.geometry.deleteAttribute("normal"),h.geometry.deleteAttribute("uv"),h.onBeforeRender=function(F,L,A){this.matrixWorld.copyPosition(A.matrixWorld)},Object.defineProperty(h.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(h)),Rs.copy(S.backgroundRotation),Rs.x*=-1,Rs.y*=-1,Rs.z*=-1,x.isCubeTexture&&x.isRenderTargetTexture===!1&&(Rs.y*=-1,Rs.z*=-1),h.material.uniforms.envMap.value=x,h.material.uniforms.flipEnvMap.value=x.isCubeTexture&&x.isRenderTargetTexture===!1?-1:1,h.material.uniforms.backgroundBlurriness.value=S.backgroundBlurriness,h.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,h.material.uniforms.backgroundRotation.value.setFromMatrix4(CL.makeRotationFromEuler(Rs)),h.material.toneMapped=ge.getTransfer(x.colorSpace)!==Re,(u!==x||d!==x.version||p!==i.toneMapping)&&(h.material.needsUpdate=!0,u=x,d=x.version,p=i.toneMapping),h.layers.enableAll(),M.unshift(h,h.geometry,h.material,0,0,null)):x&&x.isTexture&&(c===void 0&&(c=new dn(new Dr(2,2),new gs({name:"BackgroundMaterial",uniforms:$o(vi.background.uniforms),vertexShader:vi.background.vertexShader,fragmentShader:vi.background.fragmentShader,side:ms,depthTest:!1,depthWrite:!1,fog:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=x,c.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,c.material.toneMapped=ge.getTransfer(x.colorSpace)!==Re,x.matrixAutoUpdate===!0&&x.updateMatrix(),c.material.uniforms.uvTransform.value.copy(x.matrix),(u!==x||d!==x.version||p!==i.toneMapping)&&(c.material.needsUpdate=!0,u=x,d=x.version,p=i.toneMapping),c.layers.enableAll(),M.unshift(c,c.geometry,c.material,0,0,null))}function f(M,S){M.getRGB(ua,Um(i)),n.buffers.color.setClear(ua.r,ua.g,ua.b,S,a)}return{getClearColor:function(){return r},setClearColor:function(M,S=1){r.set(M),l=S,f(r,l)},getClearAlpha:function(){return l},setClearAlpha:function(M){l=M,f(r,l)},render:g,addToRenderList:m}}function LL(i,t){const e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null);let o=s,a=!1;function r(b,R,H,O,q){let $=!1;const X=u(O,H,R);o!==X&&(o=X,c(o.object)),$=p(b,O,H,q),$&&_(b,O,H,q),q!==null&&t.update(q,i.ELEMENT_ARRAY_BUFFER),($||a)&&(a=!1,x(b,R,H,O),q!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(q).buffer))}function l(){return i.createVertexArray()}function c(b){return i.bindVertexArray(b)}function h(b){return i.deleteVertexArray(b)}function u(b,R,H){const O=H.wireframe===!0;let q=n[b.id];q===void 0&&(q={},n[b.id]=q);let $=q[R.id];$===void 0&&($={},q[R.id]=$);let X=$[O];return X===void 0&&(X=d(l()),$[O]=X),X}function d(b){const R=[],H=[],O=[];for(let q=0;q<e;q++)R[q]=0,H[q]=0,O[q]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:R,enabledAttributes:H,attributeDivisors:O,object:b,attributes:{},index:null}}function p(b,R,H,O){const q=o.attributes,$=R.attributes;let X=0;const j=H.getAttributes();for(const Q in j)if(j[Q].location>=0){const lt=q[Q];let gt=$[Q];if(gt===void 0&&(Q==="instanceMatrix"&&b.instanceMatrix&&(gt=b.instanceMatrix),Q==="instanceColor"&&b.instanceColor&&(gt=b.instanceColor)),lt===void 0||lt.attribute!==gt||gt&&lt.data!==gt.data)return!0;X++}return o.attributesNum!==X||o.index!==O}function _(b,R,H,O){const q={},$=R.attributes;let X=0;const j=H.getAttributes();for(const Q in j)if(j[Q].location>=0){let lt=$[Q];lt===void 0&&(Q==="instanceMatrix"&&b.instanceMatrix&&(lt=b.instanceMatrix),Q==="instanceColor"&&b.instanceColor&&(lt=b.instanceColor));const gt={};gt.attribute=lt,lt&&lt.data&&(gt.data=lt.data),q[Q]=gt,X++}o.attributes=q,o.attributesNum=X,o.index=O}function g(){const b=o.newAttributes;for(let R=0,H=b.length;R<H;R++)b[R]=0}function m(b){f(b,0)}function f(b,R){const H=o.newAttributes,O=o.enabledAttributes,q=o.attributeDivisors;H[b]=1,O[b]===0&&(i.enableVertexAttribArray(b),O[b]=1),q[b]!==R&&(i.vertexAttribDivisor(b,R),q[b]=R)}function M(){const b=o.newAttributes,R=o.enabledAttributes;for(let H=0,O=R.length;H<O;H++)R[H]!==b[H]&&(i.disableVertexAttribArray(H),R[H]=0)}function S(b,R,H,O,q,$,X){X===!0?i.vertexAttribIPointer(b,R,H,q,$):i.vertexAttribPointer(b,R,H,O,q,$)}function x(b,R,H,O){g();const q=O.attributes,$=H.getAttributes(),X=R.defaultAttributeValues;for(const j in $){const Q=$[j];if(Q.location>=0){let at=q[j];if(at===void 0&&(j==="instanceMatrix"&&b.instanceMatrix&&(at=b.instanceMatrix),j==="instanceColor"&&b.instanceColor&&(at=b.instanceColor)),at!==void 0){const lt=at.normalized,gt=at.itemSize,xt=t.get(at);if(xt===void 0)continue;const mt=xt.buffer,ot=xt.type,ut=xt.bytesPerElement,_t=ot===i.INT||ot===i.UNSIGNED_INT||at.gpuType===Vh;if(at.isInterleavedBufferAttribute){const ht=at.data,It=ht.stride,zt=at.offset;if(ht.isInstancedInterleavedBuffer){for(let Ut=0;Ut<Q.locationSize;Ut++)f(Q.location+Ut,ht.meshPerAttribute);b.isInstancedMesh!==!0&&O._maxInstanceCount===void 0&&(O._maxInstanceCount=ht.meshPerAttribute*ht.count)}else for(let Ut=0;Ut<Q.locationSize;Ut++)m(Q.location+Ut);i.bindBuffer(i.ARRAY_BUFFER,mt);for(let Ut=0;Ut<Q.locationSize;Ut++)S(Q.location+Ut,gt/Q.locationSize,ot,lt,It*ut,(zt+gt/Q.locationSize*Ut)*ut,_t)}else{if(at.isInstancedBufferAttribute){for(let ht=0;ht<Q.locationSize;ht++)f(Q.location+ht,at.meshPerAttribute);b.isInstancedMesh!==!0&&O._maxInstanceCount===void 0&&(O._maxInstanceCount=at.meshPerAttribute*at.count)}else for(let ht=0;ht<Q.locationSize;ht++)m(Q.location+ht);i.bindBuffer(i.ARRAY_BUFFER,mt);for(let ht=0;ht<Q.locationSize;ht++)S(Q.location+ht,gt/Q.locationSize,ot,lt,gt*ut,gt/Q.locationSize*ht*ut,_t)}}else if(X!==void 0){const lt=X[j];if(lt!==void 0)switch(lt.length){case 2:i.vertexAttrib2fv(Q.location,lt);break;case 3:i.vertexAttrib3fv(Q.location,lt);break;case 4:i.vertexAttrib4fv(Q.location,lt);break;default:i.vertexAttrib1fv(Q.location,lt)}}}}M()}function F(){D();for(const b in n){const R=n[b];for(const H in R){const O=R[H];for(const q in O)h(O[q].object),delete O[q];delete R[H]}delete n[b]}}function L(b){if(n[b.id]===void 0)return;const R=n[b.id];for(const H in R){const O=R[H];for(const q in O)h(O[q].object),delete O[q];delete R[H]}delete n[b.id]}function A(b){for(const R in n){const H=n[R];if(H[b.id]===void 0)continue;const O=H[b.id];for(const q in O)h(O[q].object),delete O[q];delete H[b.id]}}function D(){E(),a=!0,o!==s&&(o=s,c(o.object))}function E(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:r,reset:D,resetDefaultState:E,dispose:F,releaseStatesOfGeometry:L,releaseStatesOfProgram:A,initAttributes:g,enableAttribute:m,disableUnusedAttributes:M}}function NL(i,t,e){let n;function s(c){n=c}function o(c,h){i.drawArrays(n,c,h),e.update(h,n,1)}function a(c,h,u){u!==0&&(i.drawArraysInstanced(n,c,h,u),e.update(h,n,u))}function r(c,h,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,h,0,u);let p=0;for(let _=0;_<u;_++)p+=h[_];e.update(p,n,1)}function l(c,h,u,d){if(u===0)return;const p=t.get("WEBGL_multi_draw");if(p===null)for(let _=0;_<c.length;_++)a(c[_],h[_],d[_]);else{p.multiDrawArraysInstancedWEBGL(n,c,0,h,0,d,0,u);let _=0;for(let g=0;g<u;g++)_+=h[g]*d[g];e.update(_,n,1)}}this.setMode=s,this.render=o,this.renderInstances=a,this.renderMultiDraw=r,this.renderMultiDrawInstances=l}function DL(i,t,e,n){let s;function o(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){const A=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(A.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function a(A){return!(A!==li&&n.convert(A)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function r(A){const D=A===Rr&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(A!==$i&&n.convert(A)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE)&&A!==Oi&&!D)}function l(A){if(A==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";A="mediump"}return A==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp";const h=l(c);h!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);const u=e.logarithmicDepthBuffer===!0,d=e.reverseDepthBuffer===!0&&t.has("EXT_clip_control"),p=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),_=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),f=i.getParameter(i.MAX_VERTEX_ATTRIBS),M=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),S=i.getParameter(i.MAX_VARYING_VECTORS),x=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),F=_>0,L=i.getParameter(i.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:o,getMaxPrecision:l,textureFormatReadable:a,textureTypeReadable:r,precision:c,logarithmicDepthBuffer:u,reverseDepthBuffer:d,maxTextures:p,maxVertexTextures:_,maxTextureSize:g,maxCubemapSize:m,maxAttributes:f,maxVertexUniforms:M,maxVaryings:S,maxFragmentUniforms:x,vertexTextures:F,maxSamples:L}}function IL(i){const t=this;let e=null,n=0,s=!1,o=!1;const a=new rs,r=new ne,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){const p=u.length!==0||d||n!==0||s;return s=d,n=u.length,p},this.beginShadows=function(){o=!0,h(null)},this.endShadows=function(){o=!1},this.setGlobalState=function(u,d){e=h(u,d,0)},this.setState=function(u,d,p){const _=u.clippingPlanes,g=u.clipIntersection,m=u.clipShadows,f=i.get(u);if(!s||_===null||_.length===0||o&&!m)o?h(null):c();else{const M=o?0:n,S=M*4;let x=f.clippingState||null;l.value=x,x=h(_,d,S,p);for(let F=0;F!==S;++F)x[F]=e[F];f.clippingState=x,this.numIntersection=g?this.numPlanes:0,this.numPlanes+=M}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(u,d,p,_){const g=u!==null?u.length:0;let m=null;if(g!==0){if(m=l.value,_!==!0||m===null){const f=p+g*4,M=d.matrixWorldInverse;r.getNormalMatrix(M),(m===null||m.length<f)&&(m=new Float32Array(f));for(let S=0,x=p;S!==g;++S,x+=4)a.copy(u[S]).applyMatrix4(M,r),a.normal.toArray(m,x),m[x+3]=a.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=g,t.numIntersection=0,m}}function UL(i){let t=new WeakMap;function e(a,r){return r===kc?a.mapping=Ho:r===Fc&&(a.mapping=Vo),a}function n(a){if(a&&a.isTexture){const r=a.mapping;if(r===kc||r===Fc)if(t.has(a)){const l=t.get(a).texture;return e(l,a.mapping)}else{const l=a.image;if(l&&l.height>0){const c=new qC(l.height);return c.fromEquirectangularTexture(i,a),t.set(a,c),a.addEventListener("dispose",s),e(c.texture,a.mapping)}else return null}}return a}function s(a){const r=a.target;r.removeEventListener("dispose",s);const l=t.get(r);l!==void 0&&(t.delete(r),l.dispose())}function o(){t=new WeakMap}return{get:n,dispose:o}}class Bm extends km{constructor(t=-1,e=1,n=1,s=-1,o=.1,a=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=o,this.far=a,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,o,a){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=o,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2;let o=n-t,a=n+t,r=s+e,l=s-e;if(this.view!==null&&this.view.enabled){const c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;o+=c*this.view.offsetX,a=o+c*this.view.width,r-=h*this.view.offsetY,l=r-h*this.view.height}this.projectionMatrix.makeOrthographic(o,a,r,l,this.near,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){const e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}}const Po=4,gf=[.125,.215,.35,.446,.526,.582],Fs=20,Ql=new Bm,_f=new de;let tc=null,ec=0,nc=0,ic=!1;const Ds=(1+Math.sqrt(5))/2,Eo=1/Ds,vf=[new et(-Ds,Eo,0),new et(Ds,Eo,0),new et(-Eo,0,Ds),new et(Eo,0,Ds),new et(0,Ds,-Eo),new et(0,Ds,Eo),new et(-1,1,-1),new et(1,1,-1),new et(-1,1,1),new et(1,1,1)];class xf{constructor(t){this._renderer=t,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(t,e=0,n=.1,s=100){tc=this._renderer.getRenderTarget(),ec=this._renderer.getActiveCubeFace(),nc=this._renderer.getActiveMipmapLevel(),ic=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(256);const o=this._allocateTargets();return o.depthBuffer=!0,this._sceneToCubeUV(t,n,s,o),e>0&&this._blur(o,0,0,e),this._applyPMREM(o),this._cleanup(o),o}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Mf(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=yf(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(t){this._lodMax=Math.floor(Math.log2(t)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let t=0;t<this._lodPlanes.length;t++)this._lodPlanes[t].dispose()}_cleanup(t){this._renderer.setRenderTarget(tc,ec,nc),this._renderer.xr.enabled=ic,t.scissorTest=!1,da(t,0,0,t.width,t.height)}_fromTexture(t,e){t.mapping===Ho||t.mapping===Vo?this._setSize(t.image.length===0?16:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4),tc=this._renderer.getRenderTarget(),ec=this._renderer.getActiveCubeFace(),nc=this._renderer.getActiveMipmapLevel(),ic=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;const n=e||this._allocateTargets();return this._textureToCubeUV(t,n),this._applyPMREM(n),this._cleanup(n),n}_allocateTargets(){const t=3*Math.max(this._cubeSize,112),e=4*this._cubeSize,n={magFilter:bi,minFilter:bi,generateMipmaps:!1,type:Rr,format:li,colorSpace:Zo,depthBuffer:!1},s=bf(t,e,n);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==t||this._pingPongRenderTarget.height!==e){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=bf(t,e,n);const{_lodMax:o}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=kL(o)),this._blurMaterial=FL(o,t,e)}return s}_compileMaterial(t){const e=new dn(this._lodPlanes[0],t);this._renderer.compile(e,Ql)}_sceneToCubeUV(t,e,n,s){const r=new Yn(90,1,e,n),l=[1,-1,1,1,1,1],c=[1,1,1,-1,-1,-1],h=this._renderer,u=h.autoClear,d=h.toneMapping;h.getClearColor(_f),h.toneMapping=hs,h.autoClear=!1;const p=new Kh({name:"PMREM.Background",side:Pn,depthWrite:!1,depthTest:!1}),_=new dn(new Ys,p);let g=!1;const m=t.background;m?m.isColor&&(p.color.copy(m),t.background=null,g=!0):(p.color.copy(_f),g=!0);for(let f=0;f<6;f++){const M=f%3;M===0?(r.up.set(0,l[f],0),r.lookAt(c[f],0,0)):M===1?(r.up.set(0,0,l[f]),r.lookAt(0,c[f],0)):(r.up.set(0,l[f],0),r.lookAt(0,0,c[f]));const S=this._cubeSize;da(s,M*S,f>2?S:0,S,S),h.setRenderTarget(s),g&&h.render(_,r),h.render(t,r)}_.geometry.dispose(),_.material.dispose(),h.toneMapping=d,h.autoClear=u,t.background=m}_textureToCubeUV(t,e){const n=this._renderer,s=t.mapping===Ho||t.mapping===Vo;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=Mf()),this._cubemapMaterial.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=yf());const o=s?this._cubemapMaterial:this._equirectMaterial,a=new dn(this._lodPlanes[0],o),r=o.uniforms;r.envMap.value=t;const l=this._cubeSize;da(e,0,0,3*l,2*l),n.setRenderTarget(e),n.render(a,Ql)}_applyPMREM(t){const e=this._renderer,n=e.autoClear;e.autoClear=!1;const s=this._lodPlanes.length;for(let o=1;o<s;o++){const a=Math.sqrt(this._sigmas[o]*this._sigmas[o]-this._sigmas[o-1]*this._sigmas[o-1]),r=vf[(s-o-1)%vf.length];this._blur(t,o-1,o,a,r)}e.autoClear=n}_blur(t,e,n,s,o){const a=this._pingPongRenderTarget;this._halfBlur(t,a,e,n,s,"latitudinal",o),this._halfBlur(a,t,n,n,s,"longitudinal",o)}_halfBlur(t,e,n,s,o,a,r){const l=this._renderer,c=this._blurMaterial;a!=="latitudinal"&&a!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");const h=3,u=new dn(this._lodPlanes[s],c),d=c.uniforms,p=this._sizeLods[n]-1,_=isFinite(o)?Math.PI/(2*p):2*Math.PI/(2*Fs-1),g=o/_,m=isFinite(o)?1+Math.floor(h*g):Fs;m>Fs&&console.warn(`sigmaRadians, ${o}, is too large and will clip, as it requested ${m} samples when the maximum is set to ${Fs}`);const f=[];let M=0;for(let A=0;A<Fs;++A){const D=A/g,E=Math.exp(-D*D/2);f.push(E),A===0?M+=E:A<m&&(M+=2*E)}for(let A=0;A<f.length;A++)f[A]=f[A]/M;d.envMap.value=t.texture,d.samples.value=m,d.weights.value=f,d.latitudinal.value=a==="latitudinal",r&&(d.poleAxis.value=r);const{_lodMax:S}=this;d.dTheta.value=_,d.mipInt.value=S-n;const x=this._sizeLods[s],F=3*x*(s>S-Po?s-S+Po:0),L=4*(this._cubeSize-x);da(e,F,L,3*x,2*x),l.setRenderTarget(e),l.render(u,Ql)}}function kL(i){const t=[],e=[],n=[];let s=i;const o=i-Po+1+gf.length;for(let a=0;a<o;a++){const r=Math.pow(2,s);e.push(r);let l=1/r;a>i-Po?l=gf[a-i+Po-1]:a===0&&(l=0),n.push(l);const c=1/(r-2),h=-c,u=1+c,d=[h,h,u,h,u,u,h,h,u,u,h,u],p=6,_=6,g=3,m=2,f=1,M=new Float32Array(g*_*p),S=new Float32Array(m*_*p),x=new Float32Array(f*_*p);for(let L=0;L<p;L++){const A=L%3*2/3-1,D=L>2?0:-1,E=[A,D,0,A+2/3,D,0,A+2/3,D+1,0,A,D,0,A+2/3,D+1,0,A,D+1,0];M.set(E,g*_*L),S.set(d,m*_*L);const b=[L,L,L,L,L,L];x.set(b,f*_*L)}const F=new _s;F.setAttribute("position",new Si(M,g)),F.setAttribute("uv",new Si(S,m)),F.setAttribute("faceIndex",new Si(x,f)),t.push(F),s>Po&&s--}return{lodPlanes:t,sizeLods:e,sigmas:n}}function bf(i,t,e){const n=new js(i,t,e);return n.texture.mapping=el,n.texture.name="PMREM.cubeUv",n.scissorTest=!0,n}function da(i,t,e,n,s){i.viewport.set(t,e,n,s),i.scissor.set(t,e,n,s)}function FL(i,t,e){const n=new Float32Array(Fs),s=new et(0,1,0);return new gs({name:"SphericalGaussianBlur",defines:{n:Fs,CUBEUV_TEXEL_WIDTH:1/t,CUBEUV_TEXEL_HEIGHT:1/e,CUBEUV_MAX_MIP:`${i}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:n},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:Jh(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;
			uniform int samples;
			uniform float weights[ n ];
			uniform bool latitudinal;
			uniform float dTheta;
			uniform float mipInt;
			uniform vec3 poleAxis;

			#define ENVMAP_TYPE_CUBE_UV
			#include <cube_uv_reflection_fragment>

			vec3 getSample( float theta, vec3 axis ) {

				float cosTheta = cos( theta );
				// Rodrigues' axis-angle rotation
				vec3 sampleDirection = vOutputDirection * cosTheta
					+ cross( axis, vOutputDirection ) * sin( theta )
					+ axis * dot( axis, vOutputDirection ) * ( 1.0 - cosTheta );

				return bilinearCubeUV( envMap, sampleDirection, mipInt );

			}

			void main() {

				vec3 axis = latitudinal ? poleAxis : cross( poleAxis, vOutputDirection );

				if ( all( equal( axis, vec3( 0.0 ) ) ) ) {

					axis = vec3( vOutputDirection.z, 0.0, - vOutputDirection.x );

				}

				axis = normalize( axis );

				gl_FragColor = vec4( 0.0, 0.0, 0.0, 1.0 );
				gl_FragColor.rgb += weights[ 0 ] * getSample( 0.0, axis );

				for ( int i = 1; i < n; i++ ) {

					if ( i >= samples ) {

						break;

					}

					float theta = dTheta * float( i );
					gl_FragColor.rgb += weights[ i ] * getSample( -1.0 * theta, axis );
					gl_FragColor.rgb += weights[ i ] * getSample( theta, axis );

				}

			}
		`,blending:cs,depthTest:!1,depthWrite:!1})}function yf(){return new gs({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:Jh(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;

			#include <common>

			void main() {

				vec3 outputDirection = normalize( vOutputDirection );
				vec2 uv = equirectUv( outputDirection );

				gl_FragColor = vec4( texture2D ( envMap, uv ).rgb, 1.0 );

			}
		`,blending:cs,depthTest:!1,depthWrite:!1})}function Mf(){return new gs({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:Jh(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:cs,depthTest:!1,depthWrite:!1})}function Jh(){return`

		precision mediump float;
		precision mediump int;

		attribute float faceIndex;

		varying vec3 vOutputDirection;

		// RH coordinate system; PMREM face-indexing convention
		vec3 getDirection( vec2 uv, float face ) {

			uv = 2.0 * uv - 1.0;

			vec3 direction = vec3( uv, 1.0 );

			if ( face == 0.0 ) {

				direction = direction.zyx; // ( 1, v, u ) pos x

			} else if ( face == 1.0 ) {

				direction = direction.xzy;
				direction.xz *= -1.0; // ( -u, 1, -v ) pos y

			} else if ( face == 2.0 ) {

				direction.x *= -1.0; // ( -u, v, 1 ) pos z

			} else if ( face == 3.0 ) {

				direction = direction.zyx;
				direction.xz *= -1.0; // ( -1, v, -u ) neg x

			} else if ( face == 4.0 ) {

				direction = direction.xzy;
				direction.xy *= -1.0; // ( -u, -1, v ) neg y

			} else if ( face == 5.0 ) {

				direction.z *= -1.0; // ( u, v, -1 ) neg z

			}

			return direction;

		}

		void main() {

			vOutputDirection = getDirection( uv, faceIndex );
			gl_Position = vec4( position, 1.0 );

		}
	`}function OL(i){let t=new WeakMap,e=null;function n(r){if(r&&r.isTexture){const l=r.mapping,c=l===kc||l===Fc,h=l===Ho||l===Vo;if(c||h){let u=t.get(r);const d=u!==void 0?u.texture.pmremVersion:0;if(r.isRenderTargetTexture&&r.pmremVersion!==d)return e===null&&(e=new xf(i)),u=c?e.fromEquirectangular(r,u):e.fromCubemap(r,u),u.texture.pmremVersion=r.pmremVersion,t.set(r,u),u.texture;if(u!==void 0)return u.texture;{const p=r.image;return c&&p&&p.height>0||h&&p&&s(p)?(e===null&&(e=new xf(i)),u=c?e.fromEquirectangular(r):e.fromCubemap(r),u.texture.pmremVersion=r.pmremVersion,t.set(r,u),r.addEventListener("dispose",o),u.texture):null}}}return r}function s(r){let l=0;const c=6;for(let h=0;h<c;h++)r[h]!==void 0&&l++;return l===c}function o(r){const l=r.target;l.removeEventListener("dispose",o);const c=t.get(l);c!==void 0&&(t.delete(l),c.dispose())}function a(){t=new WeakMap,e!==null&&(e.dispose(),e=null)}return{get:n,dispose:a}}function BL(i){const t={};function e(n){if(t[n]!==void 0)return t[n];let s;switch(n){case"WEBGL_depth_texture":s=i.getExtension("WEBGL_depth_texture")||i.getExtension("MOZ_WEBGL_depth_texture")||i.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=i.getExtension("EXT_texture_filter_anisotropic")||i.getExtension("MOZ_EXT_texture_filter_anisotropic")||i.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=i.getExtension("WEBGL_compressed_texture_s3tc")||i.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=i.getExtension("WEBGL_compressed_texture_pvrtc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=i.getExtension(n)}return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){const s=e(n);return s===null&&vr("THREE.WebGLRenderer: "+n+" extension not supported."),s}}}function zL(i,t,e,n){const s={},o=new WeakMap;function a(u){const d=u.target;d.index!==null&&t.remove(d.index);for(const _ in d.attributes)t.remove(d.attributes[_]);for(const _ in d.morphAttributes){const g=d.morphAttributes[_];for(let m=0,f=g.length;m<f;m++)t.remove(g[m])}d.removeEventListener("dispose",a),delete s[d.id];const p=o.get(d);p&&(t.remove(p),o.delete(d)),n.releaseStatesOfGeometry(d),d.isInstancedBufferGeometry===!0&&delete d._maxInstanceCount,e.memory.geometries--}function r(u,d){return s[d.id]===!0||(d.addEventListener("dispose",a),s[d.id]=!0,e.memory.geometries++),d}function l(u){const d=u.attributes;for(const _ in d)t.update(d[_],i.ARRAY_BUFFER);const p=u.morphAttributes;for(const _ in p){const g=p[_];for(let m=0,f=g.length;m<f;m++)t.update(g[m],i.ARRAY_BUFFER)}}function c(u){const d=[],p=u.index,_=u.attributes.position;let g=0;if(p!==null){const M=p.array;g=p.version;for(let S=0,x=M.length;S<x;S+=3){const F=M[S+0],L=M[S+1],A=M[S+2];d.push(F,L,L,A,A,F)}}else if(_!==void 0){const M=_.array;g=_.version;for(let S=0,x=M.length/3-1;S<x;S+=3){const F=S+0,L=S+1,A=S+2;d.push(F,L,L,A,A,F)}}else return;const m=new(Rm(d)?Im:Dm)(d,1);m.version=g;const f=o.get(u);f&&t.remove(f),o.set(u,m)}function h(u){const d=o.get(u);if(d){const p=u.index;p!==null&&d.version<p.version&&c(u)}else c(u);return o.get(u)}return{get:r,update:l,getWireframeAttribute:h}}function HL(i,t,e){let n;function s(d){n=d}let o,a;function r(d){o=d.type,a=d.bytesPerElement}function l(d,p){i.drawElements(n,p,o,d*a),e.update(p,n,1)}function c(d,p,_){_!==0&&(i.drawElementsInstanced(n,p,o,d*a,_),e.update(p,n,_))}function h(d,p,_){if(_===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,p,0,o,d,0,_);let m=0;for(let f=0;f<_;f++)m+=p[f];e.update(m,n,1)}function u(d,p,_,g){if(_===0)return;const m=t.get("WEBGL_multi_draw");if(m===null)for(let f=0;f<d.length;f++)c(d[f]/a,p[f],g[f]);else{m.multiDrawElementsInstancedWEBGL(n,p,0,o,d,0,g,0,_);let f=0;for(let M=0;M<_;M++)f+=p[M]*g[M];e.update(f,n,1)}}this.setMode=s,this.setIndex=r,this.render=l,this.renderInstances=c,this.renderMultiDraw=h,this.renderMultiDrawInstances=u}function VL(i){const t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(o,a,r){switch(e.calls++,a){case i.TRIANGLES:e.triangles+=r*(o/3);break;case i.LINES:e.lines+=r*(o/2);break;case i.LINE_STRIP:e.lines+=r*(o-1);break;case i.LINE_LOOP:e.lines+=r*o;break;case i.POINTS:e.points+=r*o;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",a);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function GL(i,t,e){const n=new WeakMap,s=new We;function o(a,r,l){const c=a.morphTargetInfluences,h=r.morphAttributes.position||r.morphAttributes.normal||r.morphAttributes.color,u=h!==void 0?h.length:0;let d=n.get(r);if(d===void 0||d.count!==u){let b=function(){D.dispose(),n.delete(r),r.removeEventListener("dispose",b)};var p=b;d!==void 0&&d.texture.dispose();const _=r.morphAttributes.position!==void 0,g=r.morphAttributes.normal!==void 0,m=r.morphAttributes.color!==void 0,f=r.morphAttributes.position||[],M=r.morphAttributes.normal||[],S=r.morphAttributes.color||[];let x=0;_===!0&&(x=1),g===!0&&(x=2),m===!0&&(x=3);let F=r.attributes.position.count*x,L=1;F>t.maxTextureSize&&(L=Math.ceil(F/t.maxTextureSize),F=t.maxTextureSize);const A=new Float32Array(F*L*4*u),D=new Pm(A,F,L,u);D.type=Oi,D.needsUpdate=!0;const E=x*4;for(let R=0;R<u;R++){const H=f[R],O=M[R],q=S[R],$=F*L*4*R;for(let X=0;X<H.count;X++){const j=X*E;_===!0&&(s.fromBufferAttribute(H,X),A[$+j+0]=s.x,A[$+j+1]=s.y,A[$+j+2]=s.z,A[$+j+3]=0),g===!0&&(s.fromBufferAttribute(O,X),A[$+j+4]=s.x,A[$+j+5]=s.y,A[$+j+6]=s.z,A[$+j+7]=0),m===!0&&(s.fromBufferAttribute(q,X),A[$+j+8]=s.x,A[$+j+9]=s.y,A[$+j+10]=s.z,A[$+j+11]=q.itemSize===4?s.w:1)}}d={count:u,texture:D,size:new ve(F,L)},n.set(r,d),r.addEventListener("dispose",b)}if(a.isInstancedMesh===!0&&a.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",a.morphTexture,e);else{let _=0;for(let m=0;m<c.length;m++)_+=c[m];const g=r.morphTargetsRelative?1:1-_;l.getUniforms().setValue(i,"morphTargetBaseInfluence",g),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:o}}function WL(i,t,e,n){let s=new WeakMap;function o(l){const c=n.render.frame,h=l.geometry,u=t.get(l,h);if(s.get(u)!==c&&(t.update(u),s.set(u,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",r)===!1&&l.addEventListener("dispose",r),s.get(l)!==c&&(e.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,i.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){const d=l.skeleton;s.get(d)!==c&&(d.update(),s.set(d,c))}return u}function a(){s=new WeakMap}function r(l){const c=l.target;c.removeEventListener("dispose",r),e.remove(c.instanceMatrix),c.instanceColor!==null&&e.remove(c.instanceColor)}return{update:o,dispose:a}}class zm extends En{constructor(t,e,n,s,o,a,r,l,c,h=Do){if(h!==Do&&h!==Wo)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");n===void 0&&h===Do&&(n=Xs),n===void 0&&h===Wo&&(n=Go),super(null,s,o,a,r,l,h,n,c),this.isDepthTexture=!0,this.image={width:t,height:e},this.magFilter=r!==void 0?r:ci,this.minFilter=l!==void 0?l:ci,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.compareFunction=t.compareFunction,this}toJSON(t){const e=super.toJSON(t);return this.compareFunction!==null&&(e.compareFunction=this.compareFunction),e}}const Hm=new En,Sf=new zm(1,1),Vm=new Pm,Gm=new PC,Wm=new Fm,wf=[],Ef=[],Tf=new Float32Array(16),Af=new Float32Array(9),Rf=new Float32Array(4);function Qo(i,t,e){const n=i[0];if(n<=0||n>0)return i;const s=t*e;let o=wf[s];if(o===void 0&&(o=new Float32Array(s),wf[s]=o),t!==0){n.toArray(o,0);for(let a=1,r=0;a!==t;++a)r+=e,i[a].toArray(o,r)}return o}function tn(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function en(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function il(i,t){let e=Ef[t];e===void 0&&(e=new Int32Array(t),Ef[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function $L(i,t){const e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function qL(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(tn(e,t))return;i.uniform2fv(this.addr,t),en(e,t)}}function XL(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(tn(e,t))return;i.uniform3fv(this.addr,t),en(e,t)}}function jL(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(tn(e,t))return;i.uniform4fv(this.addr,t),en(e,t)}}function YL(i,t){const e=this.cache,n=t.elements;if(n===void 0){if(tn(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),en(e,t)}else{if(tn(e,n))return;Rf.set(n),i.uniformMatrix2fv(this.addr,!1,Rf),en(e,n)}}function KL(i,t){const e=this.cache,n=t.elements;if(n===void 0){if(tn(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),en(e,t)}else{if(tn(e,n))return;Af.set(n),i.uniformMatrix3fv(this.addr,!1,Af),en(e,n)}}function ZL(i,t){const e=this.cache,n=t.elements;if(n===void 0){if(tn(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),en(e,t)}else{if(tn(e,n))return;Tf.set(n),i.uniformMatrix4fv(this.addr,!1,Tf),en(e,n)}}function JL(i,t){const e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function QL(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(tn(e,t))return;i.uniform2iv(this.addr,t),en(e,t)}}function tN(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(tn(e,t))return;i.uniform3iv(this.addr,t),en(e,t)}}function eN(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(tn(e,t))return;i.uniform4iv(this.addr,t),en(e,t)}}function nN(i,t){const e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function iN(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(tn(e,t))return;i.uniform2uiv(this.addr,t),en(e,t)}}function sN(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(tn(e,t))return;i.uniform3uiv(this.addr,t),en(e,t)}}function oN(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(tn(e,t))return;i.uniform4uiv(this.addr,t),en(e,t)}}function rN(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let o;this.type===i.SAMPLER_2D_SHADOW?(Sf.compareFunction=Am,o=Sf):o=Hm,e.setTexture2D(t||o,s)}function aN(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||Gm,s)}function lN(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTextureCube(t||Wm,s)}function cN(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||Vm,s)}function hN(i){switch(i){case 5126:return $L;case 35664:return qL;case 35665:return XL;case 35666:return jL;case 35674:return YL;case 35675:return KL;case 35676:return ZL;case 5124:case 35670:return JL;case 35667:case 35671:return QL;case 35668:case 35672:return tN;case 35669:case 35673:return eN;case 5125:return nN;case 36294:return iN;case 36295:return sN;case 36296:return oN;case 35678:case 36198:case 36298:case 36306:case 35682:return rN;case 35679:case 36299:case 36307:return aN;case 35680:case 36300:case 36308:case 36293:return lN;case 36289:case 36303:case 36311:case 36292:return cN}}function uN(i,t){i.uniform1fv(this.addr,t)}function dN(i,t){const e=Qo(t,this.size,2);i.uniform2fv(this.addr,e)}function fN(i,t){const e=Qo(t,this.size,3);i.uniform3fv(this.addr,e)}function pN(i,t){const e=Qo(t,this.size,4);i.uniform4fv(this.addr,e)}function mN(i,t){const e=Qo(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function gN(i,t){const e=Qo(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function _N(i,t){const e=Qo(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function vN(i,t){i.uniform1iv(this.addr,t)}function xN(i,t){i.uniform2iv(this.addr,t)}function bN(i,t){i.uniform3iv(this.addr,t)}function yN(i,t){i.uniform4iv(this.addr,t)}function MN(i,t){i.uniform1uiv(this.addr,t)}function SN(i,t){i.uniform2uiv(this.addr,t)}function wN(i,t){i.uniform3uiv(this.addr,t)}function EN(i,t){i.uniform4uiv(this.addr,t)}function TN(i,t,e){const n=this.cache,s=t.length,o=il(e,s);tn(n,o)||(i.uniform1iv(this.addr,o),en(n,o));for(let a=0;a!==s;++a)e.setTexture2D(t[a]||Hm,o[a])}function AN(i,t,e){const n=this.cache,s=t.length,o=il(e,s);tn(n,o)||(i.uniform1iv(this.addr,o),en(n,o));for(let a=0;a!==s;++a)e.setTexture3D(t[a]||Gm,o[a])}function RN(i,t,e){const n=this.cache,s=t.length,o=il(e,s);tn(n,o)||(i.uniform1iv(this.addr,o),en(n,o));for(let a=0;a!==s;++a)e.setTextureCube(t[a]||Wm,o[a])}function CN(i,t,e){const n=this.cache,s=t.length,o=il(e,s);tn(n,o)||(i.uniform1iv(this.addr,o),en(n,o));for(let a=0;a!==s;++a)e.setTexture2DArray(t[a]||Vm,o[a])}function PN(i){switch(i){case 5126:return uN;case 35664:return dN;case 35665:return fN;case 35666:return pN;case 35674:return mN;case 35675:return gN;case 35676:return _N;case 5124:case 35670:return vN;case 35667:case 35671:return xN;case 35668:case 35672:return bN;case 35669:case 35673:return yN;case 5125:return MN;case 36294:return SN;case 36295:return wN;case 36296:return EN;case 35678:case 36198:case 36298:case 36306:case 35682:return TN;case 35679:case 36299:case 36307:return AN;case 35680:case 36300:case 36308:case 36293:return RN;case 36289:case 36303:case 36311:case 36292:return CN}}class LN{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=hN(e.type)}}class NN{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=PN(e.type)}}class DN{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){const s=this.seq;for(let o=0,a=s.length;o!==a;++o){const r=s[o];r.setValue(t,e[r.id],n)}}}const sc=/(\w+)(\])?(\[|\.)?/g;function Cf(i,t){i.seq.push(t),i.map[t.id]=t}function IN(i,t,e){const n=i.name,s=n.length;for(sc.lastIndex=0;;){const o=sc.exec(n),a=sc.lastIndex;let r=o[1];const l=o[2]==="]",c=o[3];if(l&&(r=r|0),c===void 0||c==="["&&a+2===s){Cf(e,c===void 0?new LN(r,i,t):new NN(r,i,t));break}else{let u=e.map[r];u===void 0&&(u=new DN(r),Cf(e,u)),e=u}}}class Aa{constructor(t,e){this.seq=[],this.map={};const n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let s=0;s<n;++s){const o=t.getActiveUniform(e,s),a=t.getUniformLocation(e,o.name);IN(o,a,this)}}setValue(t,e,n,s){const o=this.map[e];o!==void 0&&o.setValue(t,n,s)}setOptional(t,e,n){const s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let o=0,a=e.length;o!==a;++o){const r=e[o],l=n[r.id];l.needsUpdate!==!1&&r.setValue(t,l.value,s)}}static seqWithValue(t,e){const n=[];for(let s=0,o=t.length;s!==o;++s){const a=t[s];a.id in e&&n.push(a)}return n}}function Pf(i,t,e){const n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}const UN=37297;let kN=0;function FN(i,t){const e=i.split(`
`),n=[],s=Math.max(t-6,0),o=Math.min(t+6,e.length);for(let a=s;a<o;a++){const r=a+1;n.push(`${r===t?">":" "} ${r}: ${e[a]}`)}return n.join(`
`)}const Lf=new ne;function ON(i){ge._getMatrix(Lf,ge.workingColorSpace,i);const t=`mat3( ${Lf.elements.map(e=>e.toFixed(4))} )`;switch(ge.getTransfer(i)){case nl:return[t,"LinearTransferOETF"];case Re:return[t,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function Nf(i,t,e){const n=i.getShaderParameter(t,i.COMPILE_STATUS),s=i.getShaderInfoLog(t).trim();if(n&&s==="")return"";const o=/ERROR: 0:(\d+)/.exec(s);if(o){const a=parseInt(o[1]);return e.toUpperCase()+`

`+s+`

`+FN(i.getShaderSource(t),a)}else return s}function BN(i,t){const e=ON(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( value.rgb * ${e[0]}, value.a ) );`,"}"].join(`
`)}function zN(i,t){let e;switch(t){case iC:e="Linear";break;case sC:e="Reinhard";break;case oC:e="Cineon";break;case rC:e="ACESFilmic";break;case lC:e="AgX";break;case cC:e="Neutral";break;case aC:e="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",t),e="Linear"}return"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}const fa=new et;function HN(){ge.getLuminanceCoefficients(fa);const i=fa.x.toFixed(4),t=fa.y.toFixed(4),e=fa.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function VN(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(xr).join(`
`)}function GN(i){const t=[];for(const e in i){const n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function WN(i,t){const e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){const o=i.getActiveAttrib(t,s),a=o.name;let r=1;o.type===i.FLOAT_MAT2&&(r=2),o.type===i.FLOAT_MAT3&&(r=3),o.type===i.FLOAT_MAT4&&(r=4),e[a]={type:o.type,location:i.getAttribLocation(t,a),locationSize:r}}return e}function xr(i){return i!==""}function Df(i,t){const e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows)}function If(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}const $N=/^[ \t]*#include +<([\w\d./]+)>/gm;function dh(i){return i.replace($N,XN)}const qN=new Map;function XN(i,t){let e=se[t];if(e===void 0){const n=qN.get(t);if(n!==void 0)e=se[n],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',t,n);else throw new Error("Can not resolve #include <"+t+">")}return dh(e)}const jN=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Uf(i){return i.replace(jN,YN)}function YN(i,t,e,n){let s="";for(let o=parseInt(t);o<parseInt(e);o++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+o+" ]").replace(/UNROLLED_LOOP_INDEX/g,o);return s}function kf(i){let t=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?t+=`
#define HIGH_PRECISION`:i.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}function KN(i){let t="SHADOWMAP_TYPE_BASIC";return i.shadowMapType===dm?t="SHADOWMAP_TYPE_PCF":i.shadowMapType===fm?t="SHADOWMAP_TYPE_PCF_SOFT":i.shadowMapType===Ui&&(t="SHADOWMAP_TYPE_VSM"),t}function ZN(i){let t="ENVMAP_TYPE_CUBE";if(i.envMap)switch(i.envMapMode){case Ho:case Vo:t="ENVMAP_TYPE_CUBE";break;case el:t="ENVMAP_TYPE_CUBE_UV";break}return t}function JN(i){let t="ENVMAP_MODE_REFLECTION";if(i.envMap)switch(i.envMapMode){case Vo:t="ENVMAP_MODE_REFRACTION";break}return t}function QN(i){let t="ENVMAP_BLENDING_NONE";if(i.envMap)switch(i.combine){case pm:t="ENVMAP_BLENDING_MULTIPLY";break;case eC:t="ENVMAP_BLENDING_MIX";break;case nC:t="ENVMAP_BLENDING_ADD";break}return t}function tD(i){const t=i.envMapCubeUVHeight;if(t===null)return null;const e=Math.log2(t)-2,n=1/t;return{texelWidth:1/(3*Math.max(Math.pow(2,e),112)),texelHeight:n,maxMip:e}}function eD(i,t,e,n){const s=i.getContext(),o=e.defines;let a=e.vertexShader,r=e.fragmentShader;const l=KN(e),c=ZN(e),h=JN(e),u=QN(e),d=tD(e),p=VN(e),_=GN(o),g=s.createProgram();let m,f,M=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,_].filter(xr).join(`
`),m.length>0&&(m+=`
`),f=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,_].filter(xr).join(`
`),f.length>0&&(f+=`
`)):(m=[kf(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,_,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",e.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(xr).join(`
`),f=[kf(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,_,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",d?"#define CUBEUV_TEXEL_WIDTH "+d.texelWidth:"",d?"#define CUBEUV_TEXEL_HEIGHT "+d.texelHeight:"",d?"#define CUBEUV_MAX_MIP "+d.maxMip+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor||e.batchingColor?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",e.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==hs?"#define TONE_MAPPING":"",e.toneMapping!==hs?se.tonemapping_pars_fragment:"",e.toneMapping!==hs?zN("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",se.colorspace_pars_fragment,BN("linearToOutputTexel",e.outputColorSpace),HN(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(xr).join(`
`)),a=dh(a),a=Df(a,e),a=If(a,e),r=dh(r),r=Df(r,e),r=If(r,e),a=Uf(a),r=Uf(r),e.isRawShaderMaterial!==!0&&(M=`#version 300 es
`,m=[p,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+m,f=["#define varying in",e.glslVersion===jd?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===jd?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+f);const S=M+m+a,x=M+f+r,F=Pf(s,s.VERTEX_SHADER,S),L=Pf(s,s.FRAGMENT_SHADER,x);s.attachShader(g,F),s.attachShader(g,L),e.index0AttributeName!==void 0?s.bindAttribLocation(g,0,e.index0AttributeName):e.morphTargets===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function A(R){if(i.debug.checkShaderErrors){const H=s.getProgramInfoLog(g).trim(),O=s.getShaderInfoLog(F).trim(),q=s.getShaderInfoLog(L).trim();let $=!0,X=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if($=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,g,F,L);else{const j=Nf(s,F,"vertex"),Q=Nf(s,L,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+R.name+`
Material Type: `+R.type+`

Program Info Log: `+H+`
`+j+`
`+Q)}else H!==""?console.warn("THREE.WebGLProgram: Program Info Log:",H):(O===""||q==="")&&(X=!1);X&&(R.diagnostics={runnable:$,programLog:H,vertexShader:{log:O,prefix:m},fragmentShader:{log:q,prefix:f}})}s.deleteShader(F),s.deleteShader(L),D=new Aa(s,g),E=WN(s,g)}let D;this.getUniforms=function(){return D===void 0&&A(this),D};let E;this.getAttributes=function(){return E===void 0&&A(this),E};let b=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return b===!1&&(b=s.getProgramParameter(g,UN)),b},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=kN++,this.cacheKey=t,this.usedTimes=1,this.program=g,this.vertexShader=F,this.fragmentShader=L,this}let nD=0;class iD{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t){const e=t.vertexShader,n=t.fragmentShader,s=this._getShaderStage(e),o=this._getShaderStage(n),a=this._getShaderCacheForMaterial(t);return a.has(s)===!1&&(a.add(s),s.usedTimes++),a.has(o)===!1&&(a.add(o),o.usedTimes++),this}remove(t){const e=this.materialCache.get(t);for(const n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderID(t){return this._getShaderStage(t.vertexShader).id}getFragmentShaderID(t){return this._getShaderStage(t.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){const e=this.materialCache;let n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){const e=this.shaderCache;let n=e.get(t);return n===void 0&&(n=new sD(t),e.set(t,n)),n}}class sD{constructor(t){this.id=nD++,this.code=t,this.usedTimes=0}}function oD(i,t,e,n,s,o,a){const r=new Yh,l=new iD,c=new Set,h=[],u=s.logarithmicDepthBuffer,d=s.vertexTextures;let p=s.precision;const _={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function g(E){return c.add(E),E===0?"uv":`uv${E}`}function m(E,b,R,H,O){const q=H.fog,$=O.geometry,X=E.isMeshStandardMaterial?H.environment:null,j=(E.isMeshStandardMaterial?e:t).get(E.envMap||X),Q=j&&j.mapping===el?j.image.height:null,at=_[E.type];E.precision!==null&&(p=s.getMaxPrecision(E.precision),p!==E.precision&&console.warn("THREE.WebGLProgram.getParameters:",E.precision,"not supported, using",p,"instead."));const lt=$.morphAttributes.position||$.morphAttributes.normal||$.morphAttributes.color,gt=lt!==void 0?lt.length:0;let xt=0;$.morphAttributes.position!==void 0&&(xt=1),$.morphAttributes.normal!==void 0&&(xt=2),$.morphAttributes.color!==void 0&&(xt=3);let mt,ot,ut,_t;if(at){const ye=vi[at];mt=ye.vertexShader,ot=ye.fragmentShader}else mt=E.vertexShader,ot=E.fragmentShader,l.update(E),ut=l.getVertexShaderID(E),_t=l.getFragmentShaderID(E);const ht=i.getRenderTarget(),It=i.state.buffers.depth.getReversed(),zt=O.isInstancedMesh===!0,Ut=O.isBatchedMesh===!0,ce=!!E.map,Jt=!!E.matcap,he=!!j,G=!!E.aoMap,je=!!E.lightMap,ee=!!E.bumpMap,ie=!!E.normalMap,Wt=!!E.displacementMap,fe=!!E.emissiveMap,Nt=!!E.metalnessMap,N=!!E.roughnessMap,w=E.anisotropy>0,tt=E.clearcoat>0,nt=E.dispersion>0,Y=E.iridescence>0,it=E.sheen>0,St=E.transmission>0,bt=w&&!!E.anisotropyMap,At=tt&&!!E.clearcoatMap,Zt=tt&&!!E.clearcoatNormalMap,pt=tt&&!!E.clearcoatRoughnessMap,yt=Y&&!!E.iridescenceMap,Ot=Y&&!!E.iridescenceThicknessMap,Ht=it&&!!E.sheenColorMap,Et=it&&!!E.sheenRoughnessMap,oe=!!E.specularMap,Yt=!!E.specularColorMap,pe=!!E.specularIntensityMap,V=St&&!!E.transmissionMap,Mt=St&&!!E.thicknessMap,st=!!E.gradientMap,ct=!!E.alphaMap,Rt=E.alphaTest>0,Ct=!!E.alphaHash,Qt=!!E.extensions;let Fe=hs;E.toneMapped&&(ht===null||ht.isXRRenderTarget===!0)&&(Fe=i.toneMapping);const nn={shaderID:at,shaderType:E.type,shaderName:E.name,vertexShader:mt,fragmentShader:ot,defines:E.defines,customVertexShaderID:ut,customFragmentShaderID:_t,isRawShaderMaterial:E.isRawShaderMaterial===!0,glslVersion:E.glslVersion,precision:p,batching:Ut,batchingColor:Ut&&O._colorsTexture!==null,instancing:zt,instancingColor:zt&&O.instanceColor!==null,instancingMorph:zt&&O.morphTexture!==null,supportsVertexTextures:d,outputColorSpace:ht===null?i.outputColorSpace:ht.isXRRenderTarget===!0?ht.texture.colorSpace:Zo,alphaToCoverage:!!E.alphaToCoverage,map:ce,matcap:Jt,envMap:he,envMapMode:he&&j.mapping,envMapCubeUVHeight:Q,aoMap:G,lightMap:je,bumpMap:ee,normalMap:ie,displacementMap:d&&Wt,emissiveMap:fe,normalMapObjectSpace:ie&&E.normalMapType===fC,normalMapTangentSpace:ie&&E.normalMapType===Tm,metalnessMap:Nt,roughnessMap:N,anisotropy:w,anisotropyMap:bt,clearcoat:tt,clearcoatMap:At,clearcoatNormalMap:Zt,clearcoatRoughnessMap:pt,dispersion:nt,iridescence:Y,iridescenceMap:yt,iridescenceThicknessMap:Ot,sheen:it,sheenColorMap:Ht,sheenRoughnessMap:Et,specularMap:oe,specularColorMap:Yt,specularIntensityMap:pe,transmission:St,transmissionMap:V,thicknessMap:Mt,gradientMap:st,opaque:E.transparent===!1&&E.blending===No&&E.alphaToCoverage===!1,alphaMap:ct,alphaTest:Rt,alphaHash:Ct,combine:E.combine,mapUv:ce&&g(E.map.channel),aoMapUv:G&&g(E.aoMap.channel),lightMapUv:je&&g(E.lightMap.channel),bumpMapUv:ee&&g(E.bumpMap.channel),normalMapUv:ie&&g(E.normalMap.channel),displacementMapUv:Wt&&g(E.displacementMap.channel),emissiveMapUv:fe&&g(E.emissiveMap.channel),metalnessMapUv:Nt&&g(E.metalnessMap.channel),roughnessMapUv:N&&g(E.roughnessMap.channel),anisotropyMapUv:bt&&g(E.anisotropyMap.channel),clearcoatMapUv:At&&g(E.clearcoatMap.channel),clearcoatNormalMapUv:Zt&&g(E.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:pt&&g(E.clearcoatRoughnessMap.channel),iridescenceMapUv:yt&&g(E.iridescenceMap.channel),iridescenceThicknessMapUv:Ot&&g(E.iridescenceThicknessMap.channel),sheenColorMapUv:Ht&&g(E.sheenColorMap.channel),sheenRoughnessMapUv:Et&&g(E.sheenRoughnessMap.channel),specularMapUv:oe&&g(E.specularMap.channel),specularColorMapUv:Yt&&g(E.specularColorMap.channel),specularIntensityMapUv:pe&&g(E.specularIntensityMap.channel),transmissionMapUv:V&&g(E.transmissionMap.channel),thicknessMapUv:Mt&&g(E.thicknessMap.channel),alphaMapUv:ct&&g(E.alphaMap.channel),vertexTangents:!!$.attributes.tangent&&(ie||w),vertexColors:E.vertexColors,vertexAlphas:E.vertexColors===!0&&!!$.attributes.color&&$.attributes.color.itemSize===4,pointsUvs:O.isPoints===!0&&!!$.attributes.uv&&(ce||ct),fog:!!q,useFog:E.fog===!0,fogExp2:!!q&&q.isFogExp2,flatShading:E.flatShading===!0,sizeAttenuation:E.sizeAttenuation===!0,logarithmicDepthBuffer:u,reverseDepthBuffer:It,skinning:O.isSkinnedMesh===!0,morphTargets:$.morphAttributes.position!==void 0,morphNormals:$.morphAttributes.normal!==void 0,morphColors:$.morphAttributes.color!==void 0,morphTargetsCount:gt,morphTextureStride:xt,numDirLights:b.directional.length,numPointLights:b.point.length,numSpotLights:b.spot.length,numSpotLightMaps:b.spotLightMap.length,numRectAreaLights:b.rectArea.length,numHemiLights:b.hemi.length,numDirLightShadows:b.directionalShadowMap.length,numPointLightShadows:b.pointShadowMap.length,numSpotLightShadows:b.spotShadowMap.length,numSpotLightShadowsWithMaps:b.numSpotLightShadowsWithMaps,numLightProbes:b.numLightProbes,numClippingPlanes:a.numPlanes,numClipIntersection:a.numIntersection,dithering:E.dithering,shadowMapEnabled:i.shadowMap.enabled&&R.length>0,shadowMapType:i.shadowMap.type,toneMapping:Fe,decodeVideoTexture:ce&&E.map.isVideoTexture===!0&&ge.getTransfer(E.map.colorSpace)===Re,decodeVideoTextureEmissive:fe&&E.emissiveMap.isVideoTexture===!0&&ge.getTransfer(E.emissiveMap.colorSpace)===Re,premultipliedAlpha:E.premultipliedAlpha,doubleSided:E.side===Fi,flipSided:E.side===Pn,useDepthPacking:E.depthPacking>=0,depthPacking:E.depthPacking||0,index0AttributeName:E.index0AttributeName,extensionClipCullDistance:Qt&&E.extensions.clipCullDistance===!0&&n.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Qt&&E.extensions.multiDraw===!0||Ut)&&n.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:n.has("KHR_parallel_shader_compile"),customProgramCacheKey:E.customProgramCacheKey()};return nn.vertexUv1s=c.has(1),nn.vertexUv2s=c.has(2),nn.vertexUv3s=c.has(3),c.clear(),nn}function f(E){const b=[];if(E.shaderID?b.push(E.shaderID):(b.push(E.customVertexShaderID),b.push(E.customFragmentShaderID)),E.defines!==void 0)for(const R in E.defines)b.push(R),b.push(E.defines[R]);return E.isRawShaderMaterial===!1&&(M(b,E),S(b,E),b.push(i.outputColorSpace)),b.push(E.customProgramCacheKey),b.join()}function M(E,b){E.push(b.precision),E.push(b.outputColorSpace),E.push(b.envMapMode),E.push(b.envMapCubeUVHeight),E.push(b.mapUv),E.push(b.alphaMapUv),E.push(b.lightMapUv),E.push(b.aoMapUv),E.push(b.bumpMapUv),E.push(b.normalMapUv),E.push(b.displacementMapUv),E.push(b.emissiveMapUv),E.push(b.metalnessMapUv),E.push(b.roughnessMapUv),E.push(b.anisotropyMapUv),E.push(b.clearcoatMapUv),E.push(b.clearcoatNormalMapUv),E.push(b.clearcoatRoughnessMapUv),E.push(b.iridescenceMapUv),E.push(b.iridescenceThicknessMapUv),E.push(b.sheenColorMapUv),E.push(b.sheenRoughnessMapUv),E.push(b.specularMapUv),E.push(b.specularColorMapUv),E.push(b.specularIntensityMapUv),E.push(b.transmissionMapUv),E.push(b.thicknessMapUv),E.push(b.combine),E.push(b.fogExp2),E.push(b.sizeAttenuation),E.push(b.morphTargetsCount),E.push(b.morphAttributeCount),E.push(b.numDirLights),E.push(b.numPointLights),E.push(b.numSpotLights),E.push(b.numSpotLightMaps),E.push(b.numHemiLights),E.push(b.numRectAreaLights),E.push(b.numDirLightShadows),E.push(b.numPointLightShadows),E.push(b.numSpotLightShadows),E.push(b.numSpotLightShadowsWithMaps),E.push(b.numLightProbes),E.push(b.shadowMapType),E.push(b.toneMapping),E.push(b.numClippingPlanes),E.push(b.numClipIntersection),E.push(b.depthPacking)}function S(E,b){r.disableAll(),b.supportsVertexTextures&&r.enable(0),b.instancing&&r.enable(1),b.instancingColor&&r.enable(2),b.instancingMorph&&r.enable(3),b.matcap&&r.enable(4),b.envMap&&r.enable(5),b.normalMapObjectSpace&&r.enable(6),b.normalMapTangentSpace&&r.enable(7),b.clearcoat&&r.enable(8),b.iridescence&&r.enable(9),b.alphaTest&&r.enable(10),b.vertexColors&&r.enable(11),b.vertexAlphas&&r.enable(12),b.vertexUv1s&&r.enable(13),b.vertexUv2s&&r.enable(14),b.vertexUv3s&&r.enable(15),b.vertexTangents&&r.enable(16),b.anisotropy&&r.enable(17),b.alphaHash&&r.enable(18),b.batching&&r.enable(19),b.dispersion&&r.enable(20),b.batchingColor&&r.enable(21),E.push(r.mask),r.disableAll(),b.fog&&r.enable(0),b.useFog&&r.enable(1),b.flatShading&&r.enable(2),b.logarithmicDepthBuffer&&r.enable(3),b.reverseDepthBuffer&&r.enable(4),b.skinning&&r.enable(5),b.morphTargets&&r.enable(6),b.morphNormals&&r.enable(7),b.morphColors&&r.enable(8),b.premultipliedAlpha&&r.enable(9),b.shadowMapEnabled&&r.enable(10),b.doubleSided&&r.enable(11),b.flipSided&&r.enable(12),b.useDepthPacking&&r.enable(13),b.dithering&&r.enable(14),b.transmission&&r.enable(15),b.sheen&&r.enable(16),b.opaque&&r.enable(17),b.pointsUvs&&r.enable(18),b.decodeVideoTexture&&r.enable(19),b.decodeVideoTextureEmissive&&r.enable(20),b.alphaToCoverage&&r.enable(21),E.push(r.mask)}function x(E){const b=_[E.type];let R;if(b){const H=vi[b];R=VC.clone(H.uniforms)}else R=E.uniforms;return R}function F(E,b){let R;for(let H=0,O=h.length;H<O;H++){const q=h[H];if(q.cacheKey===b){R=q,++R.usedTimes;break}}return R===void 0&&(R=new eD(i,b,E,o),h.push(R)),R}function L(E){if(--E.usedTimes===0){const b=h.indexOf(E);h[b]=h[h.length-1],h.pop(),E.destroy()}}function A(E){l.remove(E)}function D(){l.dispose()}return{getParameters:m,getProgramCacheKey:f,getUniforms:x,acquireProgram:F,releaseProgram:L,releaseShaderCache:A,programs:h,dispose:D}}function rD(){let i=new WeakMap;function t(a){return i.has(a)}function e(a){let r=i.get(a);return r===void 0&&(r={},i.set(a,r)),r}function n(a){i.delete(a)}function s(a,r,l){i.get(a)[r]=l}function o(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:o}}function aD(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.z!==t.z?i.z-t.z:i.id-t.id}function Ff(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function Of(){const i=[];let t=0;const e=[],n=[],s=[];function o(){t=0,e.length=0,n.length=0,s.length=0}function a(u,d,p,_,g,m){let f=i[t];return f===void 0?(f={id:u.id,object:u,geometry:d,material:p,groupOrder:_,renderOrder:u.renderOrder,z:g,group:m},i[t]=f):(f.id=u.id,f.object=u,f.geometry=d,f.material=p,f.groupOrder=_,f.renderOrder=u.renderOrder,f.z=g,f.group=m),t++,f}function r(u,d,p,_,g,m){const f=a(u,d,p,_,g,m);p.transmission>0?n.push(f):p.transparent===!0?s.push(f):e.push(f)}function l(u,d,p,_,g,m){const f=a(u,d,p,_,g,m);p.transmission>0?n.unshift(f):p.transparent===!0?s.unshift(f):e.unshift(f)}function c(u,d){e.length>1&&e.sort(u||aD),n.length>1&&n.sort(d||Ff),s.length>1&&s.sort(d||Ff)}function h(){for(let u=t,d=i.length;u<d;u++){const p=i[u];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:n,transparent:s,init:o,push:r,unshift:l,finish:h,sort:c}}function lD(){let i=new WeakMap;function t(n,s){const o=i.get(n);let a;return o===void 0?(a=new Of,i.set(n,[a])):s>=o.length?(a=new Of,o.push(a)):a=o[s],a}function e(){i=new WeakMap}return{get:t,dispose:e}}function cD(){const i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"DirectionalLight":e={direction:new et,color:new de};break;case"SpotLight":e={position:new et,direction:new et,color:new de,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new et,color:new de,distance:0,decay:0};break;case"HemisphereLight":e={direction:new et,skyColor:new de,groundColor:new de};break;case"RectAreaLight":e={color:new de,position:new et,halfWidth:new et,halfHeight:new et};break}return i[t.id]=e,e}}}function hD(){const i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ve};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ve};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ve,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}let uD=0;function dD(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function fD(i){const t=new cD,e=hD(),n={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new et);const s=new et,o=new He,a=new He;function r(c){let h=0,u=0,d=0;for(let E=0;E<9;E++)n.probe[E].set(0,0,0);let p=0,_=0,g=0,m=0,f=0,M=0,S=0,x=0,F=0,L=0,A=0;c.sort(dD);for(let E=0,b=c.length;E<b;E++){const R=c[E],H=R.color,O=R.intensity,q=R.distance,$=R.shadow&&R.shadow.map?R.shadow.map.texture:null;if(R.isAmbientLight)h+=H.r*O,u+=H.g*O,d+=H.b*O;else if(R.isLightProbe){for(let X=0;X<9;X++)n.probe[X].addScaledVector(R.sh.coefficients[X],O);A++}else if(R.isDirectionalLight){const X=t.get(R);if(X.color.copy(R.color).multiplyScalar(R.intensity),R.castShadow){const j=R.shadow,Q=e.get(R);Q.shadowIntensity=j.intensity,Q.shadowBias=j.bias,Q.shadowNormalBias=j.normalBias,Q.shadowRadius=j.radius,Q.shadowMapSize=j.mapSize,n.directionalShadow[p]=Q,n.directionalShadowMap[p]=$,n.directionalShadowMatrix[p]=R.shadow.matrix,M++}n.directional[p]=X,p++}else if(R.isSpotLight){const X=t.get(R);X.position.setFromMatrixPosition(R.matrixWorld),X.color.copy(H).multiplyScalar(O),X.distance=q,X.coneCos=Math.cos(R.angle),X.penumbraCos=Math.cos(R.angle*(1-R.penumbra)),X.decay=R.decay,n.spot[g]=X;const j=R.shadow;if(R.map&&(n.spotLightMap[F]=R.map,F++,j.updateMatrices(R),R.castShadow&&L++),n.spotLightMatrix[g]=j.matrix,R.castShadow){const Q=e.get(R);Q.shadowIntensity=j.intensity,Q.shadowBias=j.bias,Q.shadowNormalBias=j.normalBias,Q.shadowRadius=j.radius,Q.shadowMapSize=j.mapSize,n.spotShadow[g]=Q,n.spotShadowMap[g]=$,x++}g++}else if(R.isRectAreaLight){const X=t.get(R);X.color.copy(H).multiplyScalar(O),X.halfWidth.set(R.width*.5,0,0),X.halfHeight.set(0,R.height*.5,0),n.rectArea[m]=X,m++}else if(R.isPointLight){const X=t.get(R);if(X.color.copy(R.color).multiplyScalar(R.intensity),X.distance=R.distance,X.decay=R.decay,R.castShadow){const j=R.shadow,Q=e.get(R);Q.shadowIntensity=j.intensity,Q.shadowBias=j.bias,Q.shadowNormalBias=j.normalBias,Q.shadowRadius=j.radius,Q.shadowMapSize=j.mapSize,Q.shadowCameraNear=j.camera.near,Q.shadowCameraFar=j.camera.far,n.pointShadow[_]=Q,n.pointShadowMap[_]=$,n.pointShadowMatrix[_]=R.shadow.matrix,S++}n.point[_]=X,_++}else if(R.isHemisphereLight){const X=t.get(R);X.skyColor.copy(R.color).multiplyScalar(O),X.groundColor.copy(R.groundColor).multiplyScalar(O),n.hemi[f]=X,f++}}m>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Tt.LTC_FLOAT_1,n.rectAreaLTC2=Tt.LTC_FLOAT_2):(n.rectAreaLTC1=Tt.LTC_HALF_1,n.rectAreaLTC2=Tt.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=d;const D=n.hash;(D.directionalLength!==p||D.pointLength!==_||D.spotLength!==g||D.rectAreaLength!==m||D.hemiLength!==f||D.numDirectionalShadows!==M||D.numPointShadows!==S||D.numSpotShadows!==x||D.numSpotMaps!==F||D.numLightProbes!==A)&&(n.directional.length=p,n.spot.length=g,n.rectArea.length=m,n.point.length=_,n.hemi.length=f,n.directionalShadow.length=M,n.directionalShadowMap.length=M,n.pointShadow.length=S,n.pointShadowMap.length=S,n.spotShadow.length=x,n.spotShadowMap.length=x,n.directionalShadowMatrix.length=M,n.pointShadowMatrix.length=S,n.spotLightMatrix.length=x+F-L,n.spotLightMap.length=F,n.numSpotLightShadowsWithMaps=L,n.numLightProbes=A,D.directionalLength=p,D.pointLength=_,D.spotLength=g,D.rectAreaLength=m,D.hemiLength=f,D.numDirectionalShadows=M,D.numPointShadows=S,D.numSpotShadows=x,D.numSpotMaps=F,D.numLightProbes=A,n.version=uD++)}function l(c,h){let u=0,d=0,p=0,_=0,g=0;const m=h.matrixWorldInverse;for(let f=0,M=c.length;f<M;f++){const S=c[f];if(S.isDirectionalLight){const x=n.directional[u];x.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),x.direction.sub(s),x.direction.transformDirection(m),u++}else if(S.isSpotLight){const x=n.spot[p];x.position.setFromMatrixPosition(S.matrixWorld),x.position.applyMatrix4(m),x.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),x.direction.sub(s),x.direction.transformDirection(m),p++}else if(S.isRectAreaLight){const x=n.rectArea[_];x.position.setFromMatrixPosition(S.matrixWorld),x.position.applyMatrix4(m),a.identity(),o.copy(S.matrixWorld),o.premultiply(m),a.extractRotation(o),x.halfWidth.set(S.width*.5,0,0),x.halfHeight.set(0,S.height*.5,0),x.halfWidth.applyMatrix4(a),x.halfHeight.applyMatrix4(a),_++}else if(S.isPointLight){const x=n.point[d];x.position.setFromMatrixPosition(S.matrixWorld),x.position.applyMatrix4(m),d++}else if(S.isHemisphereLight){const x=n.hemi[g];x.direction.setFromMatrixPosition(S.matrixWorld),x.direction.transformDirection(m),g++}}}return{setup:r,setupView:l,state:n}}function Bf(i){const t=new fD(i),e=[],n=[];function s(h){c.camera=h,e.length=0,n.length=0}function o(h){e.push(h)}function a(h){n.push(h)}function r(){t.setup(e)}function l(h){t.setupView(e,h)}const c={lightsArray:e,shadowsArray:n,camera:null,lights:t,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:r,setupLightsView:l,pushLight:o,pushShadow:a}}function pD(i){let t=new WeakMap;function e(s,o=0){const a=t.get(s);let r;return a===void 0?(r=new Bf(i),t.set(s,[r])):o>=a.length?(r=new Bf(i),a.push(r)):r=a[o],r}function n(){t=new WeakMap}return{get:e,dispose:n}}class mD extends Nr{static get type(){return"MeshDepthMaterial"}constructor(t){super(),this.isMeshDepthMaterial=!0,this.depthPacking=uC,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}}class gD extends Nr{static get type(){return"MeshDistanceMaterial"}constructor(t){super(),this.isMeshDistanceMaterial=!0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}}const _D=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,vD=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
#include <packing>
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = unpackRGBATo2Half( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ) );
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = unpackRGBAToDepth( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ) );
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( squared_mean - mean * mean );
	gl_FragColor = pack2HalfToRGBA( vec2( mean, std_dev ) );
}`;function xD(i,t,e){let n=new Zh;const s=new ve,o=new ve,a=new We,r=new mD({depthPacking:dC}),l=new gD,c={},h=e.maxTextureSize,u={[ms]:Pn,[Pn]:ms,[Fi]:Fi},d=new gs({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new ve},radius:{value:4}},vertexShader:_D,fragmentShader:vD}),p=d.clone();p.defines.HORIZONTAL_PASS=1;const _=new _s;_.setAttribute("position",new Si(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));const g=new dn(_,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=dm;let f=this.type;this.render=function(L,A,D){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||L.length===0)return;const E=i.getRenderTarget(),b=i.getActiveCubeFace(),R=i.getActiveMipmapLevel(),H=i.state;H.setBlending(cs),H.buffers.color.setClear(1,1,1,1),H.buffers.depth.setTest(!0),H.setScissorTest(!1);const O=f!==Ui&&this.type===Ui,q=f===Ui&&this.type!==Ui;for(let $=0,X=L.length;$<X;$++){const j=L[$],Q=j.shadow;if(Q===void 0){console.warn("THREE.WebGLShadowMap:",j,"has no shadow.");continue}if(Q.autoUpdate===!1&&Q.needsUpdate===!1)continue;s.copy(Q.mapSize);const at=Q.getFrameExtents();if(s.multiply(at),o.copy(Q.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(o.x=Math.floor(h/at.x),s.x=o.x*at.x,Q.mapSize.x=o.x),s.y>h&&(o.y=Math.floor(h/at.y),s.y=o.y*at.y,Q.mapSize.y=o.y)),Q.map===null||O===!0||q===!0){const gt=this.type!==Ui?{minFilter:ci,magFilter:ci}:{};Q.map!==null&&Q.map.dispose(),Q.map=new js(s.x,s.y,gt),Q.map.texture.name=j.name+".shadowMap",Q.camera.updateProjectionMatrix()}i.setRenderTarget(Q.map),i.clear();const lt=Q.getViewportCount();for(let gt=0;gt<lt;gt++){const xt=Q.getViewport(gt);a.set(o.x*xt.x,o.y*xt.y,o.x*xt.z,o.y*xt.w),H.viewport(a),Q.updateMatrices(j,gt),n=Q.getFrustum(),x(A,D,Q.camera,j,this.type)}Q.isPointLightShadow!==!0&&this.type===Ui&&M(Q,D),Q.needsUpdate=!1}f=this.type,m.needsUpdate=!1,i.setRenderTarget(E,b,R)};function M(L,A){const D=t.update(g);d.defines.VSM_SAMPLES!==L.blurSamples&&(d.defines.VSM_SAMPLES=L.blurSamples,p.defines.VSM_SAMPLES=L.blurSamples,d.needsUpdate=!0,p.needsUpdate=!0),L.mapPass===null&&(L.mapPass=new js(s.x,s.y)),d.uniforms.shadow_pass.value=L.map.texture,d.uniforms.resolution.value=L.mapSize,d.uniforms.radius.value=L.radius,i.setRenderTarget(L.mapPass),i.clear(),i.renderBufferDirect(A,null,D,d,g,null),p.uniforms.shadow_pass.value=L.mapPass.texture,p.uniforms.resolution.value=L.mapSize,p.uniforms.radius.value=L.radius,i.setRenderTarget(L.map),i.clear(),i.renderBufferDirect(A,null,D,p,g,null)}function S(L,A,D,E){let b=null;const R=D.isPointLight===!0?L.customDistanceMaterial:L.customDepthMaterial;if(R!==void 0)b=R;else if(b=D.isPointLight===!0?l:r,i.localClippingEnabled&&A.clipShadows===!0&&Array.isArray(A.clippingPlanes)&&A.clippingPlanes.length!==0||A.displacementMap&&A.displacementScale!==0||A.alphaMap&&A.alphaTest>0||A.map&&A.alphaTest>0){const H=b.uuid,O=A.uuid;let q=c[H];q===void 0&&(q={},c[H]=q);let $=q[O];$===void 0&&($=b.clone(),q[O]=$,A.addEventListener("dispose",F)),b=$}if(b.visible=A.visible,b.wireframe=A.wireframe,E===Ui?b.side=A.shadowSide!==null?A.shadowSide:A.side:b.side=A.shadowSide!==null?A.shadowSide:u[A.side],b.alphaMap=A.alphaMap,b.alphaTest=A.alphaTest,b.map=A.map,b.clipShadows=A.clipShadows,b.clippingPlanes=A.clippingPlanes,b.clipIntersection=A.clipIntersection,b.displacementMap=A.displacementMap,b.displacementScale=A.displacementScale,b.displacementBias=A.displacementBias,b.wireframeLinewidth=A.wireframeLinewidth,b.linewidth=A.linewidth,D.isPointLight===!0&&b.isMeshDistanceMaterial===!0){const H=i.properties.get(b);H.light=D}return b}function x(L,A,D,E,b){if(L.visible===!1)return;if(L.layers.test(A.layers)&&(L.isMesh||L.isLine||L.isPoints)&&(L.castShadow||L.receiveShadow&&b===Ui)&&(!L.frustumCulled||n.intersectsObject(L))){L.modelViewMatrix.multiplyMatrices(D.matrixWorldInverse,L.matrixWorld);const O=t.update(L),q=L.material;if(Array.isArray(q)){const $=O.groups;for(let X=0,j=$.length;X<j;X++){const Q=$[X],at=q[Q.materialIndex];if(at&&at.visible){const lt=S(L,at,E,b);L.onBeforeShadow(i,L,A,D,O,lt,Q),i.renderBufferDirect(D,null,O,lt,L,Q),L.onAfterShadow(i,L,A,D,O,lt,Q)}}}else if(q.visible){const $=S(L,q,E,b);L.onBeforeShadow(i,L,A,D,O,$,null),i.renderBufferDirect(D,null,O,$,L,null),L.onAfterShadow(i,L,A,D,O,$,null)}}const H=L.children;for(let O=0,q=H.length;O<q;O++)x(H[O],A,D,E,b)}function F(L){L.target.removeEventListener("dispose",F);for(const D in c){const E=c[D],b=L.target.uuid;b in E&&(E[b].dispose(),delete E[b])}}}const bD={[Cc]:Pc,[Lc]:Ic,[Nc]:Uc,[zo]:Dc,[Pc]:Cc,[Ic]:Lc,[Uc]:Nc,[Dc]:zo};function yD(i,t){function e(){let V=!1;const Mt=new We;let st=null;const ct=new We(0,0,0,0);return{setMask:function(Rt){st!==Rt&&!V&&(i.colorMask(Rt,Rt,Rt,Rt),st=Rt)},setLocked:function(Rt){V=Rt},setClear:function(Rt,Ct,Qt,Fe,nn){nn===!0&&(Rt*=Fe,Ct*=Fe,Qt*=Fe),Mt.set(Rt,Ct,Qt,Fe),ct.equals(Mt)===!1&&(i.clearColor(Rt,Ct,Qt,Fe),ct.copy(Mt))},reset:function(){V=!1,st=null,ct.set(-1,0,0,0)}}}function n(){let V=!1,Mt=!1,st=null,ct=null,Rt=null;return{setReversed:function(Ct){if(Mt!==Ct){const Qt=t.get("EXT_clip_control");Mt?Qt.clipControlEXT(Qt.LOWER_LEFT_EXT,Qt.ZERO_TO_ONE_EXT):Qt.clipControlEXT(Qt.LOWER_LEFT_EXT,Qt.NEGATIVE_ONE_TO_ONE_EXT);const Fe=Rt;Rt=null,this.setClear(Fe)}Mt=Ct},getReversed:function(){return Mt},setTest:function(Ct){Ct?ht(i.DEPTH_TEST):It(i.DEPTH_TEST)},setMask:function(Ct){st!==Ct&&!V&&(i.depthMask(Ct),st=Ct)},setFunc:function(Ct){if(Mt&&(Ct=bD[Ct]),ct!==Ct){switch(Ct){case Cc:i.depthFunc(i.NEVER);break;case Pc:i.depthFunc(i.ALWAYS);break;case Lc:i.depthFunc(i.LESS);break;case zo:i.depthFunc(i.LEQUAL);break;case Nc:i.depthFunc(i.EQUAL);break;case Dc:i.depthFunc(i.GEQUAL);break;case Ic:i.depthFunc(i.GREATER);break;case Uc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}ct=Ct}},setLocked:function(Ct){V=Ct},setClear:function(Ct){Rt!==Ct&&(Mt&&(Ct=1-Ct),i.clearDepth(Ct),Rt=Ct)},reset:function(){V=!1,st=null,ct=null,Rt=null,Mt=!1}}}function s(){let V=!1,Mt=null,st=null,ct=null,Rt=null,Ct=null,Qt=null,Fe=null,nn=null;return{setTest:function(ye){V||(ye?ht(i.STENCIL_TEST):It(i.STENCIL_TEST))},setMask:function(ye){Mt!==ye&&!V&&(i.stencilMask(ye),Mt=ye)},setFunc:function(ye,Ye,Ne){(st!==ye||ct!==Ye||Rt!==Ne)&&(i.stencilFunc(ye,Ye,Ne),st=ye,ct=Ye,Rt=Ne)},setOp:function(ye,Ye,Ne){(Ct!==ye||Qt!==Ye||Fe!==Ne)&&(i.stencilOp(ye,Ye,Ne),Ct=ye,Qt=Ye,Fe=Ne)},setLocked:function(ye){V=ye},setClear:function(ye){nn!==ye&&(i.clearStencil(ye),nn=ye)},reset:function(){V=!1,Mt=null,st=null,ct=null,Rt=null,Ct=null,Qt=null,Fe=null,nn=null}}}const o=new e,a=new n,r=new s,l=new WeakMap,c=new WeakMap;let h={},u={},d=new WeakMap,p=[],_=null,g=!1,m=null,f=null,M=null,S=null,x=null,F=null,L=null,A=new de(0,0,0),D=0,E=!1,b=null,R=null,H=null,O=null,q=null;const $=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS);let X=!1,j=0;const Q=i.getParameter(i.VERSION);Q.indexOf("WebGL")!==-1?(j=parseFloat(/^WebGL (\d)/.exec(Q)[1]),X=j>=1):Q.indexOf("OpenGL ES")!==-1&&(j=parseFloat(/^OpenGL ES (\d)/.exec(Q)[1]),X=j>=2);let at=null,lt={};const gt=i.getParameter(i.SCISSOR_BOX),xt=i.getParameter(i.VIEWPORT),mt=new We().fromArray(gt),ot=new We().fromArray(xt);function ut(V,Mt,st,ct){const Rt=new Uint8Array(4),Ct=i.createTexture();i.bindTexture(V,Ct),i.texParameteri(V,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(V,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Qt=0;Qt<st;Qt++)V===i.TEXTURE_3D||V===i.TEXTURE_2D_ARRAY?i.texImage3D(Mt,0,i.RGBA,1,1,ct,0,i.RGBA,i.UNSIGNED_BYTE,Rt):i.texImage2D(Mt+Qt,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,Rt);return Ct}const _t={};_t[i.TEXTURE_2D]=ut(i.TEXTURE_2D,i.TEXTURE_2D,1),_t[i.TEXTURE_CUBE_MAP]=ut(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),_t[i.TEXTURE_2D_ARRAY]=ut(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),_t[i.TEXTURE_3D]=ut(i.TEXTURE_3D,i.TEXTURE_3D,1,1),o.setClear(0,0,0,1),a.setClear(1),r.setClear(0),ht(i.DEPTH_TEST),a.setFunc(zo),ee(!1),ie(Vd),ht(i.CULL_FACE),G(cs);function ht(V){h[V]!==!0&&(i.enable(V),h[V]=!0)}function It(V){h[V]!==!1&&(i.disable(V),h[V]=!1)}function zt(V,Mt){return u[V]!==Mt?(i.bindFramebuffer(V,Mt),u[V]=Mt,V===i.DRAW_FRAMEBUFFER&&(u[i.FRAMEBUFFER]=Mt),V===i.FRAMEBUFFER&&(u[i.DRAW_FRAMEBUFFER]=Mt),!0):!1}function Ut(V,Mt){let st=p,ct=!1;if(V){st=d.get(Mt),st===void 0&&(st=[],d.set(Mt,st));const Rt=V.textures;if(st.length!==Rt.length||st[0]!==i.COLOR_ATTACHMENT0){for(let Ct=0,Qt=Rt.length;Ct<Qt;Ct++)st[Ct]=i.COLOR_ATTACHMENT0+Ct;st.length=Rt.length,ct=!0}}else st[0]!==i.BACK&&(st[0]=i.BACK,ct=!0);ct&&i.drawBuffers(st)}function ce(V){return _!==V?(i.useProgram(V),_=V,!0):!1}const Jt={[ks]:i.FUNC_ADD,[OR]:i.FUNC_SUBTRACT,[BR]:i.FUNC_REVERSE_SUBTRACT};Jt[zR]=i.MIN,Jt[HR]=i.MAX;const he={[VR]:i.ZERO,[GR]:i.ONE,[WR]:i.SRC_COLOR,[Ac]:i.SRC_ALPHA,[KR]:i.SRC_ALPHA_SATURATE,[jR]:i.DST_COLOR,[qR]:i.DST_ALPHA,[$R]:i.ONE_MINUS_SRC_COLOR,[Rc]:i.ONE_MINUS_SRC_ALPHA,[YR]:i.ONE_MINUS_DST_COLOR,[XR]:i.ONE_MINUS_DST_ALPHA,[ZR]:i.CONSTANT_COLOR,[JR]:i.ONE_MINUS_CONSTANT_COLOR,[QR]:i.CONSTANT_ALPHA,[tC]:i.ONE_MINUS_CONSTANT_ALPHA};function G(V,Mt,st,ct,Rt,Ct,Qt,Fe,nn,ye){if(V===cs){g===!0&&(It(i.BLEND),g=!1);return}if(g===!1&&(ht(i.BLEND),g=!0),V!==FR){if(V!==m||ye!==E){if((f!==ks||x!==ks)&&(i.blendEquation(i.FUNC_ADD),f=ks,x=ks),ye)switch(V){case No:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Gd:i.blendFunc(i.ONE,i.ONE);break;case Wd:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case $d:i.blendFuncSeparate(i.ZERO,i.SRC_COLOR,i.ZERO,i.SRC_ALPHA);break;default:console.error("THREE.WebGLState: Invalid blending: ",V);break}else switch(V){case No:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Gd:i.blendFunc(i.SRC_ALPHA,i.ONE);break;case Wd:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case $d:i.blendFunc(i.ZERO,i.SRC_COLOR);break;default:console.error("THREE.WebGLState: Invalid blending: ",V);break}M=null,S=null,F=null,L=null,A.set(0,0,0),D=0,m=V,E=ye}return}Rt=Rt||Mt,Ct=Ct||st,Qt=Qt||ct,(Mt!==f||Rt!==x)&&(i.blendEquationSeparate(Jt[Mt],Jt[Rt]),f=Mt,x=Rt),(st!==M||ct!==S||Ct!==F||Qt!==L)&&(i.blendFuncSeparate(he[st],he[ct],he[Ct],he[Qt]),M=st,S=ct,F=Ct,L=Qt),(Fe.equals(A)===!1||nn!==D)&&(i.blendColor(Fe.r,Fe.g,Fe.b,nn),A.copy(Fe),D=nn),m=V,E=!1}function je(V,Mt){V.side===Fi?It(i.CULL_FACE):ht(i.CULL_FACE);let st=V.side===Pn;Mt&&(st=!st),ee(st),V.blending===No&&V.transparent===!1?G(cs):G(V.blending,V.blendEquation,V.blendSrc,V.blendDst,V.blendEquationAlpha,V.blendSrcAlpha,V.blendDstAlpha,V.blendColor,V.blendAlpha,V.premultipliedAlpha),a.setFunc(V.depthFunc),a.setTest(V.depthTest),a.setMask(V.depthWrite),o.setMask(V.colorWrite);const ct=V.stencilWrite;r.setTest(ct),ct&&(r.setMask(V.stencilWriteMask),r.setFunc(V.stencilFunc,V.stencilRef,V.stencilFuncMask),r.setOp(V.stencilFail,V.stencilZFail,V.stencilZPass)),fe(V.polygonOffset,V.polygonOffsetFactor,V.polygonOffsetUnits),V.alphaToCoverage===!0?ht(i.SAMPLE_ALPHA_TO_COVERAGE):It(i.SAMPLE_ALPHA_TO_COVERAGE)}function ee(V){b!==V&&(V?i.frontFace(i.CW):i.frontFace(i.CCW),b=V)}function ie(V){V!==UR?(ht(i.CULL_FACE),V!==R&&(V===Vd?i.cullFace(i.BACK):V===kR?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):It(i.CULL_FACE),R=V}function Wt(V){V!==H&&(X&&i.lineWidth(V),H=V)}function fe(V,Mt,st){V?(ht(i.POLYGON_OFFSET_FILL),(O!==Mt||q!==st)&&(i.polygonOffset(Mt,st),O=Mt,q=st)):It(i.POLYGON_OFFSET_FILL)}function Nt(V){V?ht(i.SCISSOR_TEST):It(i.SCISSOR_TEST)}function N(V){V===void 0&&(V=i.TEXTURE0+$-1),at!==V&&(i.activeTexture(V),at=V)}function w(V,Mt,st){st===void 0&&(at===null?st=i.TEXTURE0+$-1:st=at);let ct=lt[st];ct===void 0&&(ct={type:void 0,texture:void 0},lt[st]=ct),(ct.type!==V||ct.texture!==Mt)&&(at!==st&&(i.activeTexture(st),at=st),i.bindTexture(V,Mt||_t[V]),ct.type=V,ct.texture=Mt)}function tt(){const V=lt[at];V!==void 0&&V.type!==void 0&&(i.bindTexture(V.type,null),V.type=void 0,V.texture=void 0)}function nt(){try{i.compressedTexImage2D.apply(i,arguments)}catch(V){console.error("THREE.WebGLState:",V)}}function Y(){try{i.compressedTexImage3D.apply(i,arguments)}catch(V){console.error("THREE.WebGLState:",V)}}function it(){try{i.texSubImage2D.apply(i,arguments)}catch(V){console.error("THREE.WebGLState:",V)}}function St(){try{i.texSubImage3D.apply(i,arguments)}catch(V){console.error("THREE.WebGLState:",V)}}function bt(){try{i.compressedTexSubImage2D.apply(i,arguments)}catch(V){console.error("THREE.WebGLState:",V)}}function At(){try{i.compressedTexSubImage3D.apply(i,arguments)}catch(V){console.error("THREE.WebGLState:",V)}}function Zt(){try{i.texStorage2D.apply(i,arguments)}catch(V){console.error("THREE.WebGLState:",V)}}function pt(){try{i.texStorage3D.apply(i,arguments)}catch(V){console.error("THREE.WebGLState:",V)}}function yt(){try{i.texImage2D.apply(i,arguments)}catch(V){console.error("THREE.WebGLState:",V)}}function Ot(){try{i.texImage3D.apply(i,arguments)}catch(V){console.error("THREE.WebGLState:",V)}}function Ht(V){mt.equals(V)===!1&&(i.scissor(V.x,V.y,V.z,V.w),mt.copy(V))}function Et(V){ot.equals(V)===!1&&(i.viewport(V.x,V.y,V.z,V.w),ot.copy(V))}function oe(V,Mt){let st=c.get(Mt);st===void 0&&(st=new WeakMap,c.set(Mt,st));let ct=st.get(V);ct===void 0&&(ct=i.getUniformBlockIndex(Mt,V.name),st.set(V,ct))}function Yt(V,Mt){const ct=c.get(Mt).get(V);l.get(Mt)!==ct&&(i.uniformBlockBinding(Mt,ct,V.__bindingPointIndex),l.set(Mt,ct))}function pe(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),a.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),h={},at=null,lt={},u={},d=new WeakMap,p=[],_=null,g=!1,m=null,f=null,M=null,S=null,x=null,F=null,L=null,A=new de(0,0,0),D=0,E=!1,b=null,R=null,H=null,O=null,q=null,mt.set(0,0,i.canvas.width,i.canvas.height),ot.set(0,0,i.canvas.width,i.canvas.height),o.reset(),a.reset(),r.reset()}return{buffers:{color:o,depth:a,stencil:r},enable:ht,disable:It,bindFramebuffer:zt,drawBuffers:Ut,useProgram:ce,setBlending:G,setMaterial:je,setFlipSided:ee,setCullFace:ie,setLineWidth:Wt,setPolygonOffset:fe,setScissorTest:Nt,activeTexture:N,bindTexture:w,unbindTexture:tt,compressedTexImage2D:nt,compressedTexImage3D:Y,texImage2D:yt,texImage3D:Ot,updateUBOMapping:oe,uniformBlockBinding:Yt,texStorage2D:Zt,texStorage3D:pt,texSubImage2D:it,texSubImage3D:St,compressedTexSubImage2D:bt,compressedTexSubImage3D:At,scissor:Ht,viewport:Et,reset:pe}}function zf(i,t,e,n){const s=MD(n);switch(e){case xm:return i*t;case ym:return i*t;case Mm:return i*t*2;case Sm:return i*t/s.components*s.byteLength;case $h:return i*t/s.components*s.byteLength;case wm:return i*t*2/s.components*s.byteLength;case qh:return i*t*2/s.components*s.byteLength;case bm:return i*t*3/s.components*s.byteLength;case li:return i*t*4/s.components*s.byteLength;case Xh:return i*t*4/s.components*s.byteLength;case Ma:case Sa:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case wa:case Ea:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case zc:case Vc:return Math.max(i,16)*Math.max(t,8)/4;case Bc:case Hc:return Math.max(i,8)*Math.max(t,8)/2;case Gc:case Wc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case $c:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case qc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Xc:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case jc:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case Yc:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case Kc:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case Zc:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case Jc:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case Qc:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case th:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case eh:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case nh:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case ih:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case sh:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case oh:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case Ta:case rh:case ah:return Math.ceil(i/4)*Math.ceil(t/4)*16;case Em:case lh:return Math.ceil(i/4)*Math.ceil(t/4)*8;case ch:case hh:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function MD(i){switch(i){case $i:case gm:return{byteLength:1,components:1};case Tr:case _m:case Rr:return{byteLength:2,components:1};case Gh:case Wh:return{byteLength:2,components:4};case Xs:case Vh:case Oi:return{byteLength:4,components:1};case vm:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${i}.`)}function SD(i,t,e,n,s,o,a){const r=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new ve,h=new WeakMap;let u;const d=new WeakMap;let p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function _(N,w){return p?new OffscreenCanvas(N,w):Ba("canvas")}function g(N,w,tt){let nt=1;const Y=Nt(N);if((Y.width>tt||Y.height>tt)&&(nt=tt/Math.max(Y.width,Y.height)),nt<1)if(typeof HTMLImageElement<"u"&&N instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&N instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&N instanceof ImageBitmap||typeof VideoFrame<"u"&&N instanceof VideoFrame){const it=Math.floor(nt*Y.width),St=Math.floor(nt*Y.height);u===void 0&&(u=_(it,St));const bt=w?_(it,St):u;return bt.width=it,bt.height=St,bt.getContext("2d").drawImage(N,0,0,it,St),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+Y.width+"x"+Y.height+") to ("+it+"x"+St+")."),bt}else return"data"in N&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+Y.width+"x"+Y.height+")."),N;return N}function m(N){return N.generateMipmaps}function f(N){i.generateMipmap(N)}function M(N){return N.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:N.isWebGL3DRenderTarget?i.TEXTURE_3D:N.isWebGLArrayRenderTarget||N.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function S(N,w,tt,nt,Y=!1){if(N!==null){if(i[N]!==void 0)return i[N];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+N+"'")}let it=w;if(w===i.RED&&(tt===i.FLOAT&&(it=i.R32F),tt===i.HALF_FLOAT&&(it=i.R16F),tt===i.UNSIGNED_BYTE&&(it=i.R8)),w===i.RED_INTEGER&&(tt===i.UNSIGNED_BYTE&&(it=i.R8UI),tt===i.UNSIGNED_SHORT&&(it=i.R16UI),tt===i.UNSIGNED_INT&&(it=i.R32UI),tt===i.BYTE&&(it=i.R8I),tt===i.SHORT&&(it=i.R16I),tt===i.INT&&(it=i.R32I)),w===i.RG&&(tt===i.FLOAT&&(it=i.RG32F),tt===i.HALF_FLOAT&&(it=i.RG16F),tt===i.UNSIGNED_BYTE&&(it=i.RG8)),w===i.RG_INTEGER&&(tt===i.UNSIGNED_BYTE&&(it=i.RG8UI),tt===i.UNSIGNED_SHORT&&(it=i.RG16UI),tt===i.UNSIGNED_INT&&(it=i.RG32UI),tt===i.BYTE&&(it=i.RG8I),tt===i.SHORT&&(it=i.RG16I),tt===i.INT&&(it=i.RG32I)),w===i.RGB_INTEGER&&(tt===i.UNSIGNED_BYTE&&(it=i.RGB8UI),tt===i.UNSIGNED_SHORT&&(it=i.RGB16UI),tt===i.UNSIGNED_INT&&(it=i.RGB32UI),tt===i.BYTE&&(it=i.RGB8I),tt===i.SHORT&&(it=i.RGB16I),tt===i.INT&&(it=i.RGB32I)),w===i.RGBA_INTEGER&&(tt===i.UNSIGNED_BYTE&&(it=i.RGBA8UI),tt===i.UNSIGNED_SHORT&&(it=i.RGBA16UI),tt===i.UNSIGNED_INT&&(it=i.RGBA32UI),tt===i.BYTE&&(it=i.RGBA8I),tt===i.SHORT&&(it=i.RGBA16I),tt===i.INT&&(it=i.RGBA32I)),w===i.RGB&&tt===i.UNSIGNED_INT_5_9_9_9_REV&&(it=i.RGB9_E5),w===i.RGBA){const St=Y?nl:ge.getTransfer(nt);tt===i.FLOAT&&(it=i.RGBA32F),tt===i.HALF_FLOAT&&(it=i.RGBA16F),tt===i.UNSIGNED_BYTE&&(it=St===Re?i.SRGB8_ALPHA8:i.RGBA8),tt===i.UNSIGNED_SHORT_4_4_4_4&&(it=i.RGBA4),tt===i.UNSIGNED_SHORT_5_5_5_1&&(it=i.RGB5_A1)}return(it===i.R16F||it===i.R32F||it===i.RG16F||it===i.RG32F||it===i.RGBA16F||it===i.RGBA32F)&&t.get("EXT_color_buffer_float"),it}function x(N,w){let tt;return N?w===null||w===Xs||w===Go?tt=i.DEPTH24_STENCIL8:w===Oi?tt=i.DEPTH32F_STENCIL8:w===Tr&&(tt=i.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):w===null||w===Xs||w===Go?tt=i.DEPTH_COMPONENT24:w===Oi?tt=i.DEPTH_COMPONENT32F:w===Tr&&(tt=i.DEPTH_COMPONENT16),tt}function F(N,w){return m(N)===!0||N.isFramebufferTexture&&N.minFilter!==ci&&N.minFilter!==bi?Math.log2(Math.max(w.width,w.height))+1:N.mipmaps!==void 0&&N.mipmaps.length>0?N.mipmaps.length:N.isCompressedTexture&&Array.isArray(N.image)?w.mipmaps.length:1}function L(N){const w=N.target;w.removeEventListener("dispose",L),D(w),w.isVideoTexture&&h.delete(w)}function A(N){const w=N.target;w.removeEventListener("dispose",A),b(w)}function D(N){const w=n.get(N);if(w.__webglInit===void 0)return;const tt=N.source,nt=d.get(tt);if(nt){const Y=nt[w.__cacheKey];Y.usedTimes--,Y.usedTimes===0&&E(N),Object.keys(nt).length===0&&d.delete(tt)}n.remove(N)}function E(N){const w=n.get(N);i.deleteTexture(w.__webglTexture);const tt=N.source,nt=d.get(tt);delete nt[w.__cacheKey],a.memory.textures--}function b(N){const w=n.get(N);if(N.depthTexture&&(N.depthTexture.dispose(),n.remove(N.depthTexture)),N.isWebGLCubeRenderTarget)for(let nt=0;nt<6;nt++){if(Array.isArray(w.__webglFramebuffer[nt]))for(let Y=0;Y<w.__webglFramebuffer[nt].length;Y++)i.deleteFramebuffer(w.__webglFramebuffer[nt][Y]);else i.deleteFramebuffer(w.__webglFramebuffer[nt]);w.__webglDepthbuffer&&i.deleteRenderbuffer(w.__webglDepthbuffer[nt])}else{if(Array.isArray(w.__webglFramebuffer))for(let nt=0;nt<w.__webglFramebuffer.length;nt++)i.deleteFramebuffer(w.__webglFramebuffer[nt]);else i.deleteFramebuffer(w.__webglFramebuffer);if(w.__webglDepthbuffer&&i.deleteRenderbuffer(w.__webglDepthbuffer),w.__webglMultisampledFramebuffer&&i.deleteFramebuffer(w.__webglMultisampledFramebuffer),w.__webglColorRenderbuffer)for(let nt=0;nt<w.__webglColorRenderbuffer.length;nt++)w.__webglColorRenderbuffer[nt]&&i.deleteRenderbuffer(w.__webglColorRenderbuffer[nt]);w.__webglDepthRenderbuffer&&i.deleteRenderbuffer(w.__webglDepthRenderbuffer)}const tt=N.textures;for(let nt=0,Y=tt.length;nt<Y;nt++){const it=n.get(tt[nt]);it.__webglTexture&&(i.deleteTexture(it.__webglTexture),a.memory.textures--),n.remove(tt[nt])}n.remove(N)}let R=0;function H(){R=0}function O(){const N=R;return N>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+N+" texture units while this GPU supports only "+s.maxTextures),R+=1,N}function q(N){const w=[];return w.push(N.wrapS),w.push(N.wrapT),w.push(N.wrapR||0),w.push(N.magFilter),w.push(N.minFilter),w.push(N.anisotropy),w.push(N.internalFormat),w.push(N.format),w.push(N.type),w.push(N.generateMipmaps),w.push(N.premultiplyAlpha),w.push(N.flipY),w.push(N.unpackAlignment),w.push(N.colorSpace),w.join()}function $(N,w){const tt=n.get(N);if(N.isVideoTexture&&Wt(N),N.isRenderTargetTexture===!1&&N.version>0&&tt.__version!==N.version){const nt=N.image;if(nt===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(nt.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{ot(tt,N,w);return}}e.bindTexture(i.TEXTURE_2D,tt.__webglTexture,i.TEXTURE0+w)}function X(N,w){const tt=n.get(N);if(N.version>0&&tt.__version!==N.version){ot(tt,N,w);return}e.bindTexture(i.TEXTURE_2D_ARRAY,tt.__webglTexture,i.TEXTURE0+w)}function j(N,w){const tt=n.get(N);if(N.version>0&&tt.__version!==N.version){ot(tt,N,w);return}e.bindTexture(i.TEXTURE_3D,tt.__webglTexture,i.TEXTURE0+w)}function Q(N,w){const tt=n.get(N);if(N.version>0&&tt.__version!==N.version){ut(tt,N,w);return}e.bindTexture(i.TEXTURE_CUBE_MAP,tt.__webglTexture,i.TEXTURE0+w)}const at={[Fa]:i.REPEAT,[Os]:i.CLAMP_TO_EDGE,[Oc]:i.MIRRORED_REPEAT},lt={[ci]:i.NEAREST,[hC]:i.NEAREST_MIPMAP_NEAREST,[Xr]:i.NEAREST_MIPMAP_LINEAR,[bi]:i.LINEAR,[Pl]:i.LINEAR_MIPMAP_NEAREST,[Bs]:i.LINEAR_MIPMAP_LINEAR},gt={[pC]:i.NEVER,[bC]:i.ALWAYS,[mC]:i.LESS,[Am]:i.LEQUAL,[gC]:i.EQUAL,[xC]:i.GEQUAL,[_C]:i.GREATER,[vC]:i.NOTEQUAL};function xt(N,w){if(w.type===Oi&&t.has("OES_texture_float_linear")===!1&&(w.magFilter===bi||w.magFilter===Pl||w.magFilter===Xr||w.magFilter===Bs||w.minFilter===bi||w.minFilter===Pl||w.minFilter===Xr||w.minFilter===Bs)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(N,i.TEXTURE_WRAP_S,at[w.wrapS]),i.texParameteri(N,i.TEXTURE_WRAP_T,at[w.wrapT]),(N===i.TEXTURE_3D||N===i.TEXTURE_2D_ARRAY)&&i.texParameteri(N,i.TEXTURE_WRAP_R,at[w.wrapR]),i.texParameteri(N,i.TEXTURE_MAG_FILTER,lt[w.magFilter]),i.texParameteri(N,i.TEXTURE_MIN_FILTER,lt[w.minFilter]),w.compareFunction&&(i.texParameteri(N,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(N,i.TEXTURE_COMPARE_FUNC,gt[w.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(w.magFilter===ci||w.minFilter!==Xr&&w.minFilter!==Bs||w.type===Oi&&t.has("OES_texture_float_linear")===!1)return;if(w.anisotropy>1||n.get(w).__currentAnisotropy){const tt=t.get("EXT_texture_filter_anisotropic");i.texParameterf(N,tt.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(w.anisotropy,s.getMaxAnisotropy())),n.get(w).__currentAnisotropy=w.anisotropy}}}function mt(N,w){let tt=!1;N.__webglInit===void 0&&(N.__webglInit=!0,w.addEventListener("dispose",L));const nt=w.source;let Y=d.get(nt);Y===void 0&&(Y={},d.set(nt,Y));const it=q(w);if(it!==N.__cacheKey){Y[it]===void 0&&(Y[it]={texture:i.createTexture(),usedTimes:0},a.memory.textures++,tt=!0),Y[it].usedTimes++;const St=Y[N.__cacheKey];St!==void 0&&(Y[N.__cacheKey].usedTimes--,St.usedTimes===0&&E(w)),N.__cacheKey=it,N.__webglTexture=Y[it].texture}return tt}function ot(N,w,tt){let nt=i.TEXTURE_2D;(w.isDataArrayTexture||w.isCompressedArrayTexture)&&(nt=i.TEXTURE_2D_ARRAY),w.isData3DTexture&&(nt=i.TEXTURE_3D);const Y=mt(N,w),it=w.source;e.bindTexture(nt,N.__webglTexture,i.TEXTURE0+tt);const St=n.get(it);if(it.version!==St.__version||Y===!0){e.activeTexture(i.TEXTURE0+tt);const bt=ge.getPrimaries(ge.workingColorSpace),At=w.colorSpace===as?null:ge.getPrimaries(w.colorSpace),Zt=w.colorSpace===as||bt===At?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,w.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,w.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Zt);let pt=g(w.image,!1,s.maxTextureSize);pt=fe(w,pt);const yt=o.convert(w.format,w.colorSpace),Ot=o.convert(w.type);let Ht=S(w.internalFormat,yt,Ot,w.colorSpace,w.isVideoTexture);xt(nt,w);let Et;const oe=w.mipmaps,Yt=w.isVideoTexture!==!0,pe=St.__version===void 0||Y===!0,V=it.dataReady,Mt=F(w,pt);if(w.isDepthTexture)Ht=x(w.format===Wo,w.type),pe&&(Yt?e.texStorage2D(i.TEXTURE_2D,1,Ht,pt.width,pt.height):e.texImage2D(i.TEXTURE_2D,0,Ht,pt.width,pt.height,0,yt,Ot,null));else if(w.isDataTexture)if(oe.length>0){Yt&&pe&&e.texStorage2D(i.TEXTURE_2D,Mt,Ht,oe[0].width,oe[0].height);for(let st=0,ct=oe.length;st<ct;st++)Et=oe[st],Yt?V&&e.texSubImage2D(i.TEXTURE_2D,st,0,0,Et.width,Et.height,yt,Ot,Et.data):e.texImage2D(i.TEXTURE_2D,st,Ht,Et.width,Et.height,0,yt,Ot,Et.data);w.generateMipmaps=!1}else Yt?(pe&&e.texStorage2D(i.TEXTURE_2D,Mt,Ht,pt.width,pt.height),V&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,pt.width,pt.height,yt,Ot,pt.data)):e.texImage2D(i.TEXTURE_2D,0,Ht,pt.width,pt.height,0,yt,Ot,pt.data);else if(w.isCompressedTexture)if(w.isCompressedArrayTexture){Yt&&pe&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Mt,Ht,oe[0].width,oe[0].height,pt.depth);for(let st=0,ct=oe.length;st<ct;st++)if(Et=oe[st],w.format!==li)if(yt!==null)if(Yt){if(V)if(w.layerUpdates.size>0){const Rt=zf(Et.width,Et.height,w.format,w.type);for(const Ct of w.layerUpdates){const Qt=Et.data.subarray(Ct*Rt/Et.data.BYTES_PER_ELEMENT,(Ct+1)*Rt/Et.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,st,0,0,Ct,Et.width,Et.height,1,yt,Qt)}w.clearLayerUpdates()}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,st,0,0,0,Et.width,Et.height,pt.depth,yt,Et.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,st,Ht,Et.width,Et.height,pt.depth,0,Et.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Yt?V&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,st,0,0,0,Et.width,Et.height,pt.depth,yt,Ot,Et.data):e.texImage3D(i.TEXTURE_2D_ARRAY,st,Ht,Et.width,Et.height,pt.depth,0,yt,Ot,Et.data)}else{Yt&&pe&&e.texStorage2D(i.TEXTURE_2D,Mt,Ht,oe[0].width,oe[0].height);for(let st=0,ct=oe.length;st<ct;st++)Et=oe[st],w.format!==li?yt!==null?Yt?V&&e.compressedTexSubImage2D(i.TEXTURE_2D,st,0,0,Et.width,Et.height,yt,Et.data):e.compressedTexImage2D(i.TEXTURE_2D,st,Ht,Et.width,Et.height,0,Et.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Yt?V&&e.texSubImage2D(i.TEXTURE_2D,st,0,0,Et.width,Et.height,yt,Ot,Et.data):e.texImage2D(i.TEXTURE_2D,st,Ht,Et.width,Et.height,0,yt,Ot,Et.data)}else if(w.isDataArrayTexture)if(Yt){if(pe&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Mt,Ht,pt.width,pt.height,pt.depth),V)if(w.layerUpdates.size>0){const st=zf(pt.width,pt.height,w.format,w.type);for(const ct of w.layerUpdates){const Rt=pt.data.subarray(ct*st/pt.data.BYTES_PER_ELEMENT,(ct+1)*st/pt.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,ct,pt.width,pt.height,1,yt,Ot,Rt)}w.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,pt.width,pt.height,pt.depth,yt,Ot,pt.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,Ht,pt.width,pt.height,pt.depth,0,yt,Ot,pt.data);else if(w.isData3DTexture)Yt?(pe&&e.texStorage3D(i.TEXTURE_3D,Mt,Ht,pt.width,pt.height,pt.depth),V&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,pt.width,pt.height,pt.depth,yt,Ot,pt.data)):e.texImage3D(i.TEXTURE_3D,0,Ht,pt.width,pt.height,pt.depth,0,yt,Ot,pt.data);else if(w.isFramebufferTexture){if(pe)if(Yt)e.texStorage2D(i.TEXTURE_2D,Mt,Ht,pt.width,pt.height);else{let st=pt.width,ct=pt.height;for(let Rt=0;Rt<Mt;Rt++)e.texImage2D(i.TEXTURE_2D,Rt,Ht,st,ct,0,yt,Ot,null),st>>=1,ct>>=1}}else if(oe.length>0){if(Yt&&pe){const st=Nt(oe[0]);e.texStorage2D(i.TEXTURE_2D,Mt,Ht,st.width,st.height)}for(let st=0,ct=oe.length;st<ct;st++)Et=oe[st],Yt?V&&e.texSubImage2D(i.TEXTURE_2D,st,0,0,yt,Ot,Et):e.texImage2D(i.TEXTURE_2D,st,Ht,yt,Ot,Et);w.generateMipmaps=!1}else if(Yt){if(pe){const st=Nt(pt);e.texStorage2D(i.TEXTURE_2D,Mt,Ht,st.width,st.height)}V&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,yt,Ot,pt)}else e.texImage2D(i.TEXTURE_2D,0,Ht,yt,Ot,pt);m(w)&&f(nt),St.__version=it.version,w.onUpdate&&w.onUpdate(w)}N.__version=w.version}function ut(N,w,tt){if(w.image.length!==6)return;const nt=mt(N,w),Y=w.source;e.bindTexture(i.TEXTURE_CUBE_MAP,N.__webglTexture,i.TEXTURE0+tt);const it=n.get(Y);if(Y.version!==it.__version||nt===!0){e.activeTexture(i.TEXTURE0+tt);const St=ge.getPrimaries(ge.workingColorSpace),bt=w.colorSpace===as?null:ge.getPrimaries(w.colorSpace),At=w.colorSpace===as||St===bt?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,w.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,w.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,At);const Zt=w.isCompressedTexture||w.image[0].isCompressedTexture,pt=w.image[0]&&w.image[0].isDataTexture,yt=[];for(let ct=0;ct<6;ct++)!Zt&&!pt?yt[ct]=g(w.image[ct],!0,s.maxCubemapSize):yt[ct]=pt?w.image[ct].image:w.image[ct],yt[ct]=fe(w,yt[ct]);const Ot=yt[0],Ht=o.convert(w.format,w.colorSpace),Et=o.convert(w.type),oe=S(w.internalFormat,Ht,Et,w.colorSpace),Yt=w.isVideoTexture!==!0,pe=it.__version===void 0||nt===!0,V=Y.dataReady;let Mt=F(w,Ot);xt(i.TEXTURE_CUBE_MAP,w);let st;if(Zt){Yt&&pe&&e.texStorage2D(i.TEXTURE_CUBE_MAP,Mt,oe,Ot.width,Ot.height);for(let ct=0;ct<6;ct++){st=yt[ct].mipmaps;for(let Rt=0;Rt<st.length;Rt++){const Ct=st[Rt];w.format!==li?Ht!==null?Yt?V&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ct,Rt,0,0,Ct.width,Ct.height,Ht,Ct.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ct,Rt,oe,Ct.width,Ct.height,0,Ct.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Yt?V&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ct,Rt,0,0,Ct.width,Ct.height,Ht,Et,Ct.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ct,Rt,oe,Ct.width,Ct.height,0,Ht,Et,Ct.data)}}}else{if(st=w.mipmaps,Yt&&pe){st.length>0&&Mt++;const ct=Nt(yt[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,Mt,oe,ct.width,ct.height)}for(let ct=0;ct<6;ct++)if(pt){Yt?V&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ct,0,0,0,yt[ct].width,yt[ct].height,Ht,Et,yt[ct].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ct,0,oe,yt[ct].width,yt[ct].height,0,Ht,Et,yt[ct].data);for(let Rt=0;Rt<st.length;Rt++){const Qt=st[Rt].image[ct].image;Yt?V&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ct,Rt+1,0,0,Qt.width,Qt.height,Ht,Et,Qt.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ct,Rt+1,oe,Qt.width,Qt.height,0,Ht,Et,Qt.data)}}else{Yt?V&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ct,0,0,0,Ht,Et,yt[ct]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ct,0,oe,Ht,Et,yt[ct]);for(let Rt=0;Rt<st.length;Rt++){const Ct=st[Rt];Yt?V&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ct,Rt+1,0,0,Ht,Et,Ct.image[ct]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ct,Rt+1,oe,Ht,Et,Ct.image[ct])}}}m(w)&&f(i.TEXTURE_CUBE_MAP),it.__version=Y.version,w.onUpdate&&w.onUpdate(w)}N.__version=w.version}function _t(N,w,tt,nt,Y,it){const St=o.convert(tt.format,tt.colorSpace),bt=o.convert(tt.type),At=S(tt.internalFormat,St,bt,tt.colorSpace),Zt=n.get(w),pt=n.get(tt);if(pt.__renderTarget=w,!Zt.__hasExternalTextures){const yt=Math.max(1,w.width>>it),Ot=Math.max(1,w.height>>it);Y===i.TEXTURE_3D||Y===i.TEXTURE_2D_ARRAY?e.texImage3D(Y,it,At,yt,Ot,w.depth,0,St,bt,null):e.texImage2D(Y,it,At,yt,Ot,0,St,bt,null)}e.bindFramebuffer(i.FRAMEBUFFER,N),ie(w)?r.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,nt,Y,pt.__webglTexture,0,ee(w)):(Y===i.TEXTURE_2D||Y>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&Y<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,nt,Y,pt.__webglTexture,it),e.bindFramebuffer(i.FRAMEBUFFER,null)}function ht(N,w,tt){if(i.bindRenderbuffer(i.RENDERBUFFER,N),w.depthBuffer){const nt=w.depthTexture,Y=nt&&nt.isDepthTexture?nt.type:null,it=x(w.stencilBuffer,Y),St=w.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,bt=ee(w);ie(w)?r.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,bt,it,w.width,w.height):tt?i.renderbufferStorageMultisample(i.RENDERBUFFER,bt,it,w.width,w.height):i.renderbufferStorage(i.RENDERBUFFER,it,w.width,w.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,St,i.RENDERBUFFER,N)}else{const nt=w.textures;for(let Y=0;Y<nt.length;Y++){const it=nt[Y],St=o.convert(it.format,it.colorSpace),bt=o.convert(it.type),At=S(it.internalFormat,St,bt,it.colorSpace),Zt=ee(w);tt&&ie(w)===!1?i.renderbufferStorageMultisample(i.RENDERBUFFER,Zt,At,w.width,w.height):ie(w)?r.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Zt,At,w.width,w.height):i.renderbufferStorage(i.RENDERBUFFER,At,w.width,w.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function It(N,w){if(w&&w.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(e.bindFramebuffer(i.FRAMEBUFFER,N),!(w.depthTexture&&w.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");const nt=n.get(w.depthTexture);nt.__renderTarget=w,(!nt.__webglTexture||w.depthTexture.image.width!==w.width||w.depthTexture.image.height!==w.height)&&(w.depthTexture.image.width=w.width,w.depthTexture.image.height=w.height,w.depthTexture.needsUpdate=!0),$(w.depthTexture,0);const Y=nt.__webglTexture,it=ee(w);if(w.depthTexture.format===Do)ie(w)?r.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,Y,0,it):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,Y,0);else if(w.depthTexture.format===Wo)ie(w)?r.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,Y,0,it):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,Y,0);else throw new Error("Unknown depthTexture format")}function zt(N){const w=n.get(N),tt=N.isWebGLCubeRenderTarget===!0;if(w.__boundDepthTexture!==N.depthTexture){const nt=N.depthTexture;if(w.__depthDisposeCallback&&w.__depthDisposeCallback(),nt){const Y=()=>{delete w.__boundDepthTexture,delete w.__depthDisposeCallback,nt.removeEventListener("dispose",Y)};nt.addEventListener("dispose",Y),w.__depthDisposeCallback=Y}w.__boundDepthTexture=nt}if(N.depthTexture&&!w.__autoAllocateDepthBuffer){if(tt)throw new Error("target.depthTexture not supported in Cube render targets");It(w.__webglFramebuffer,N)}else if(tt){w.__webglDepthbuffer=[];for(let nt=0;nt<6;nt++)if(e.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer[nt]),w.__webglDepthbuffer[nt]===void 0)w.__webglDepthbuffer[nt]=i.createRenderbuffer(),ht(w.__webglDepthbuffer[nt],N,!1);else{const Y=N.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,it=w.__webglDepthbuffer[nt];i.bindRenderbuffer(i.RENDERBUFFER,it),i.framebufferRenderbuffer(i.FRAMEBUFFER,Y,i.RENDERBUFFER,it)}}else if(e.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer),w.__webglDepthbuffer===void 0)w.__webglDepthbuffer=i.createRenderbuffer(),ht(w.__webglDepthbuffer,N,!1);else{const nt=N.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Y=w.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,Y),i.framebufferRenderbuffer(i.FRAMEBUFFER,nt,i.RENDERBUFFER,Y)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function Ut(N,w,tt){const nt=n.get(N);w!==void 0&&_t(nt.__webglFramebuffer,N,N.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),tt!==void 0&&zt(N)}function ce(N){const w=N.texture,tt=n.get(N),nt=n.get(w);N.addEventListener("dispose",A);const Y=N.textures,it=N.isWebGLCubeRenderTarget===!0,St=Y.length>1;if(St||(nt.__webglTexture===void 0&&(nt.__webglTexture=i.createTexture()),nt.__version=w.version,a.memory.textures++),it){tt.__webglFramebuffer=[];for(let bt=0;bt<6;bt++)if(w.mipmaps&&w.mipmaps.length>0){tt.__webglFramebuffer[bt]=[];for(let At=0;At<w.mipmaps.length;At++)tt.__webglFramebuffer[bt][At]=i.createFramebuffer()}else tt.__webglFramebuffer[bt]=i.createFramebuffer()}else{if(w.mipmaps&&w.mipmaps.length>0){tt.__webglFramebuffer=[];for(let bt=0;bt<w.mipmaps.length;bt++)tt.__webglFramebuffer[bt]=i.createFramebuffer()}else tt.__webglFramebuffer=i.createFramebuffer();if(St)for(let bt=0,At=Y.length;bt<At;bt++){const Zt=n.get(Y[bt]);Zt.__webglTexture===void 0&&(Zt.__webglTexture=i.createTexture(),a.memory.textures++)}if(N.samples>0&&ie(N)===!1){tt.__webglMultisampledFramebuffer=i.createFramebuffer(),tt.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,tt.__webglMultisampledFramebuffer);for(let bt=0;bt<Y.length;bt++){const At=Y[bt];tt.__webglColorRenderbuffer[bt]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,tt.__webglColorRenderbuffer[bt]);const Zt=o.convert(At.format,At.colorSpace),pt=o.convert(At.type),yt=S(At.internalFormat,Zt,pt,At.colorSpace,N.isXRRenderTarget===!0),Ot=ee(N);i.renderbufferStorageMultisample(i.RENDERBUFFER,Ot,yt,N.width,N.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+bt,i.RENDERBUFFER,tt.__webglColorRenderbuffer[bt])}i.bindRenderbuffer(i.RENDERBUFFER,null),N.depthBuffer&&(tt.__webglDepthRenderbuffer=i.createRenderbuffer(),ht(tt.__webglDepthRenderbuffer,N,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(it){e.bindTexture(i.TEXTURE_CUBE_MAP,nt.__webglTexture),xt(i.TEXTURE_CUBE_MAP,w);for(let bt=0;bt<6;bt++)if(w.mipmaps&&w.mipmaps.length>0)for(let At=0;At<w.mipmaps.length;At++)_t(tt.__webglFramebuffer[bt][At],N,w,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+bt,At);else _t(tt.__webglFramebuffer[bt],N,w,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+bt,0);m(w)&&f(i.TEXTURE_CUBE_MAP),e.unbindTexture()}else if(St){for(let bt=0,At=Y.length;bt<At;bt++){const Zt=Y[bt],pt=n.get(Zt);e.bindTexture(i.TEXTURE_2D,pt.__webglTexture),xt(i.TEXTURE_2D,Zt),_t(tt.__webglFramebuffer,N,Zt,i.COLOR_ATTACHMENT0+bt,i.TEXTURE_2D,0),m(Zt)&&f(i.TEXTURE_2D)}e.unbindTexture()}else{let bt=i.TEXTURE_2D;if((N.isWebGL3DRenderTarget||N.isWebGLArrayRenderTarget)&&(bt=N.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(bt,nt.__webglTexture),xt(bt,w),w.mipmaps&&w.mipmaps.length>0)for(let At=0;At<w.mipmaps.length;At++)_t(tt.__webglFramebuffer[At],N,w,i.COLOR_ATTACHMENT0,bt,At);else _t(tt.__webglFramebuffer,N,w,i.COLOR_ATTACHMENT0,bt,0);m(w)&&f(bt),e.unbindTexture()}N.depthBuffer&&zt(N)}function Jt(N){const w=N.textures;for(let tt=0,nt=w.length;tt<nt;tt++){const Y=w[tt];if(m(Y)){const it=M(N),St=n.get(Y).__webglTexture;e.bindTexture(it,St),f(it),e.unbindTexture()}}}const he=[],G=[];function je(N){if(N.samples>0){if(ie(N)===!1){const w=N.textures,tt=N.width,nt=N.height;let Y=i.COLOR_BUFFER_BIT;const it=N.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,St=n.get(N),bt=w.length>1;if(bt)for(let At=0;At<w.length;At++)e.bindFramebuffer(i.FRAMEBUFFER,St.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+At,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,St.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+At,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,St.__webglMultisampledFramebuffer),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,St.__webglFramebuffer);for(let At=0;At<w.length;At++){if(N.resolveDepthBuffer&&(N.depthBuffer&&(Y|=i.DEPTH_BUFFER_BIT),N.stencilBuffer&&N.resolveStencilBuffer&&(Y|=i.STENCIL_BUFFER_BIT)),bt){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,St.__webglColorRenderbuffer[At]);const Zt=n.get(w[At]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,Zt,0)}i.blitFramebuffer(0,0,tt,nt,0,0,tt,nt,Y,i.NEAREST),l===!0&&(he.length=0,G.length=0,he.push(i.COLOR_ATTACHMENT0+At),N.depthBuffer&&N.resolveDepthBuffer===!1&&(he.push(it),G.push(it),i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,G)),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,he))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),bt)for(let At=0;At<w.length;At++){e.bindFramebuffer(i.FRAMEBUFFER,St.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+At,i.RENDERBUFFER,St.__webglColorRenderbuffer[At]);const Zt=n.get(w[At]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,St.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+At,i.TEXTURE_2D,Zt,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,St.__webglMultisampledFramebuffer)}else if(N.depthBuffer&&N.resolveDepthBuffer===!1&&l){const w=N.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[w])}}}function ee(N){return Math.min(s.maxSamples,N.samples)}function ie(N){const w=n.get(N);return N.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&w.__useRenderToTexture!==!1}function Wt(N){const w=a.render.frame;h.get(N)!==w&&(h.set(N,w),N.update())}function fe(N,w){const tt=N.colorSpace,nt=N.format,Y=N.type;return N.isCompressedTexture===!0||N.isVideoTexture===!0||tt!==Zo&&tt!==as&&(ge.getTransfer(tt)===Re?(nt!==li||Y!==$i)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",tt)),w}function Nt(N){return typeof HTMLImageElement<"u"&&N instanceof HTMLImageElement?(c.width=N.naturalWidth||N.width,c.height=N.naturalHeight||N.height):typeof VideoFrame<"u"&&N instanceof VideoFrame?(c.width=N.displayWidth,c.height=N.displayHeight):(c.width=N.width,c.height=N.height),c}this.allocateTextureUnit=O,this.resetTextureUnits=H,this.setTexture2D=$,this.setTexture2DArray=X,this.setTexture3D=j,this.setTextureCube=Q,this.rebindTextures=Ut,this.setupRenderTarget=ce,this.updateRenderTargetMipmap=Jt,this.updateMultisampleRenderTarget=je,this.setupDepthRenderbuffer=zt,this.setupFrameBufferTexture=_t,this.useMultisampledRTT=ie}function wD(i,t){function e(n,s=as){let o;const a=ge.getTransfer(s);if(n===$i)return i.UNSIGNED_BYTE;if(n===Gh)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Wh)return i.UNSIGNED_SHORT_5_5_5_1;if(n===vm)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===gm)return i.BYTE;if(n===_m)return i.SHORT;if(n===Tr)return i.UNSIGNED_SHORT;if(n===Vh)return i.INT;if(n===Xs)return i.UNSIGNED_INT;if(n===Oi)return i.FLOAT;if(n===Rr)return i.HALF_FLOAT;if(n===xm)return i.ALPHA;if(n===bm)return i.RGB;if(n===li)return i.RGBA;if(n===ym)return i.LUMINANCE;if(n===Mm)return i.LUMINANCE_ALPHA;if(n===Do)return i.DEPTH_COMPONENT;if(n===Wo)return i.DEPTH_STENCIL;if(n===Sm)return i.RED;if(n===$h)return i.RED_INTEGER;if(n===wm)return i.RG;if(n===qh)return i.RG_INTEGER;if(n===Xh)return i.RGBA_INTEGER;if(n===Ma||n===Sa||n===wa||n===Ea)if(a===Re)if(o=t.get("WEBGL_compressed_texture_s3tc_srgb"),o!==null){if(n===Ma)return o.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Sa)return o.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===wa)return o.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Ea)return o.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(o=t.get("WEBGL_compressed_texture_s3tc"),o!==null){if(n===Ma)return o.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Sa)return o.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===wa)return o.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Ea)return o.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Bc||n===zc||n===Hc||n===Vc)if(o=t.get("WEBGL_compressed_texture_pvrtc"),o!==null){if(n===Bc)return o.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===zc)return o.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Hc)return o.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Vc)return o.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Gc||n===Wc||n===$c)if(o=t.get("WEBGL_compressed_texture_etc"),o!==null){if(n===Gc||n===Wc)return a===Re?o.COMPRESSED_SRGB8_ETC2:o.COMPRESSED_RGB8_ETC2;if(n===$c)return a===Re?o.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:o.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(n===qc||n===Xc||n===jc||n===Yc||n===Kc||n===Zc||n===Jc||n===Qc||n===th||n===eh||n===nh||n===ih||n===sh||n===oh)if(o=t.get("WEBGL_compressed_texture_astc"),o!==null){if(n===qc)return a===Re?o.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:o.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Xc)return a===Re?o.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:o.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===jc)return a===Re?o.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:o.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Yc)return a===Re?o.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:o.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Kc)return a===Re?o.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:o.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Zc)return a===Re?o.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:o.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Jc)return a===Re?o.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:o.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Qc)return a===Re?o.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:o.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===th)return a===Re?o.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:o.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===eh)return a===Re?o.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:o.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===nh)return a===Re?o.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:o.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===ih)return a===Re?o.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:o.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===sh)return a===Re?o.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:o.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===oh)return a===Re?o.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:o.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Ta||n===rh||n===ah)if(o=t.get("EXT_texture_compression_bptc"),o!==null){if(n===Ta)return a===Re?o.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:o.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===rh)return o.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===ah)return o.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Em||n===lh||n===ch||n===hh)if(o=t.get("EXT_texture_compression_rgtc"),o!==null){if(n===Ta)return o.COMPRESSED_RED_RGTC1_EXT;if(n===lh)return o.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===ch)return o.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===hh)return o.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Go?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}class ED extends Yn{constructor(t=[]){super(),this.isArrayCamera=!0,this.cameras=t}}class yi extends fn{constructor(){super(),this.isGroup=!0,this.type="Group"}}const TD={type:"move"};class oc{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new yi,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new yi,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new et,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new et),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new yi,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new et,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new et),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){const e=this._hand;if(e)for(const n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,o=null,a=null;const r=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){a=!0;for(const g of t.hand.values()){const m=e.getJointPose(g,n),f=this._getHandJoint(c,g);m!==null&&(f.matrix.fromArray(m.transform.matrix),f.matrix.decompose(f.position,f.rotation,f.scale),f.matrixWorldNeedsUpdate=!0,f.jointRadius=m.radius),f.visible=m!==null}const h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),p=.02,_=.005;c.inputState.pinching&&d>p+_?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&d<=p-_&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(o=e.getPose(t.gripSpace,n),o!==null&&(l.matrix.fromArray(o.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,o.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(o.linearVelocity)):l.hasLinearVelocity=!1,o.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(o.angularVelocity)):l.hasAngularVelocity=!1));r!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&o!==null&&(s=o),s!==null&&(r.matrix.fromArray(s.transform.matrix),r.matrix.decompose(r.position,r.rotation,r.scale),r.matrixWorldNeedsUpdate=!0,s.linearVelocity?(r.hasLinearVelocity=!0,r.linearVelocity.copy(s.linearVelocity)):r.hasLinearVelocity=!1,s.angularVelocity?(r.hasAngularVelocity=!0,r.angularVelocity.copy(s.angularVelocity)):r.hasAngularVelocity=!1,this.dispatchEvent(TD)))}return r!==null&&(r.visible=s!==null),l!==null&&(l.visible=o!==null),c!==null&&(c.visible=a!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){const n=new yi;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}}const AD=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,RD=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`;class CD{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e,n){if(this.texture===null){const s=new En,o=t.properties.get(s);o.__webglTexture=e.texture,(e.depthNear!=n.depthNear||e.depthFar!=n.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=s}}getMesh(t){if(this.texture!==null&&this.mesh===null){const e=t.cameras[0].viewport,n=new gs({vertexShader:AD,fragmentShader:RD,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new dn(new Dr(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}}class PD extends Jo{constructor(t,e){super();const n=this;let s=null,o=1,a=null,r="local-floor",l=1,c=null,h=null,u=null,d=null,p=null,_=null;const g=new CD,m=e.getContextAttributes();let f=null,M=null;const S=[],x=[],F=new ve;let L=null;const A=new Yn;A.viewport=new We;const D=new Yn;D.viewport=new We;const E=[A,D],b=new ED;let R=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ot){let ut=S[ot];return ut===void 0&&(ut=new oc,S[ot]=ut),ut.getTargetRaySpace()},this.getControllerGrip=function(ot){let ut=S[ot];return ut===void 0&&(ut=new oc,S[ot]=ut),ut.getGripSpace()},this.getHand=function(ot){let ut=S[ot];return ut===void 0&&(ut=new oc,S[ot]=ut),ut.getHandSpace()};function O(ot){const ut=x.indexOf(ot.inputSource);if(ut===-1)return;const _t=S[ut];_t!==void 0&&(_t.update(ot.inputSource,ot.frame,c||a),_t.dispatchEvent({type:ot.type,data:ot.inputSource}))}function q(){s.removeEventListener("select",O),s.removeEventListener("selectstart",O),s.removeEventListener("selectend",O),s.removeEventListener("squeeze",O),s.removeEventListener("squeezestart",O),s.removeEventListener("squeezeend",O),s.removeEventListener("end",q),s.removeEventListener("inputsourceschange",$);for(let ot=0;ot<S.length;ot++){const ut=x[ot];ut!==null&&(x[ot]=null,S[ot].disconnect(ut))}R=null,H=null,g.reset(),t.setRenderTarget(f),p=null,d=null,u=null,s=null,M=null,mt.stop(),n.isPresenting=!1,t.setPixelRatio(L),t.setSize(F.width,F.height,!1),n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ot){o=ot,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ot){r=ot,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||a},this.setReferenceSpace=function(ot){c=ot},this.getBaseLayer=function(){return d!==null?d:p},this.getBinding=function(){return u},this.getFrame=function(){return _},this.getSession=function(){return s},this.setSession=async function(ot){if(s=ot,s!==null){if(f=t.getRenderTarget(),s.addEventListener("select",O),s.addEventListener("selectstart",O),s.addEventListener("selectend",O),s.addEventListener("squeeze",O),s.addEventListener("squeezestart",O),s.addEventListener("squeezeend",O),s.addEventListener("end",q),s.addEventListener("inputsourceschange",$),m.xrCompatible!==!0&&await e.makeXRCompatible(),L=t.getPixelRatio(),t.getSize(F),s.renderState.layers===void 0){const ut={antialias:m.antialias,alpha:!0,depth:m.depth,stencil:m.stencil,framebufferScaleFactor:o};p=new XRWebGLLayer(s,e,ut),s.updateRenderState({baseLayer:p}),t.setPixelRatio(1),t.setSize(p.framebufferWidth,p.framebufferHeight,!1),M=new js(p.framebufferWidth,p.framebufferHeight,{format:li,type:$i,colorSpace:t.outputColorSpace,stencilBuffer:m.stencil})}else{let ut=null,_t=null,ht=null;m.depth&&(ht=m.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,ut=m.stencil?Wo:Do,_t=m.stencil?Go:Xs);const It={colorFormat:e.RGBA8,depthFormat:ht,scaleFactor:o};u=new XRWebGLBinding(s,e),d=u.createProjectionLayer(It),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),M=new js(d.textureWidth,d.textureHeight,{format:li,type:$i,depthTexture:new zm(d.textureWidth,d.textureHeight,_t,void 0,void 0,void 0,void 0,void 0,void 0,ut),stencilBuffer:m.stencil,colorSpace:t.outputColorSpace,samples:m.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1})}M.isXRRenderTarget=!0,this.setFoveation(l),c=null,a=await s.requestReferenceSpace(r),mt.setContext(s),mt.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function $(ot){for(let ut=0;ut<ot.removed.length;ut++){const _t=ot.removed[ut],ht=x.indexOf(_t);ht>=0&&(x[ht]=null,S[ht].disconnect(_t))}for(let ut=0;ut<ot.added.length;ut++){const _t=ot.added[ut];let ht=x.indexOf(_t);if(ht===-1){for(let zt=0;zt<S.length;zt++)if(zt>=x.length){x.push(_t),ht=zt;break}else if(x[zt]===null){x[zt]=_t,ht=zt;break}if(ht===-1)break}const It=S[ht];It&&It.connect(_t)}}const X=new et,j=new et;function Q(ot,ut,_t){X.setFromMatrixPosition(ut.matrixWorld),j.setFromMatrixPosition(_t.matrixWorld);const ht=X.distanceTo(j),It=ut.projectionMatrix.elements,zt=_t.projectionMatrix.elements,Ut=It[14]/(It[10]-1),ce=It[14]/(It[10]+1),Jt=(It[9]+1)/It[5],he=(It[9]-1)/It[5],G=(It[8]-1)/It[0],je=(zt[8]+1)/zt[0],ee=Ut*G,ie=Ut*je,Wt=ht/(-G+je),fe=Wt*-G;if(ut.matrixWorld.decompose(ot.position,ot.quaternion,ot.scale),ot.translateX(fe),ot.translateZ(Wt),ot.matrixWorld.compose(ot.position,ot.quaternion,ot.scale),ot.matrixWorldInverse.copy(ot.matrixWorld).invert(),It[10]===-1)ot.projectionMatrix.copy(ut.projectionMatrix),ot.projectionMatrixInverse.copy(ut.projectionMatrixInverse);else{const Nt=Ut+Wt,N=ce+Wt,w=ee-fe,tt=ie+(ht-fe),nt=Jt*ce/N*Nt,Y=he*ce/N*Nt;ot.projectionMatrix.makePerspective(w,tt,nt,Y,Nt,N),ot.projectionMatrixInverse.copy(ot.projectionMatrix).invert()}}function at(ot,ut){ut===null?ot.matrixWorld.copy(ot.matrix):ot.matrixWorld.multiplyMatrices(ut.matrixWorld,ot.matrix),ot.matrixWorldInverse.copy(ot.matrixWorld).invert()}this.updateCamera=function(ot){if(s===null)return;let ut=ot.near,_t=ot.far;g.texture!==null&&(g.depthNear>0&&(ut=g.depthNear),g.depthFar>0&&(_t=g.depthFar)),b.near=D.near=A.near=ut,b.far=D.far=A.far=_t,(R!==b.near||H!==b.far)&&(s.updateRenderState({depthNear:b.near,depthFar:b.far}),R=b.near,H=b.far),A.layers.mask=ot.layers.mask|2,D.layers.mask=ot.layers.mask|4,b.layers.mask=A.layers.mask|D.layers.mask;const ht=ot.parent,It=b.cameras;at(b,ht);for(let zt=0;zt<It.length;zt++)at(It[zt],ht);It.length===2?Q(b,A,D):b.projectionMatrix.copy(A.projectionMatrix),lt(ot,b,ht)};function lt(ot,ut,_t){_t===null?ot.matrix.copy(ut.matrixWorld):(ot.matrix.copy(_t.matrixWorld),ot.matrix.invert(),ot.matrix.multiply(ut.matrixWorld)),ot.matrix.decompose(ot.position,ot.quaternion,ot.scale),ot.updateMatrixWorld(!0),ot.projectionMatrix.copy(ut.projectionMatrix),ot.projectionMatrixInverse.copy(ut.projectionMatrixInverse),ot.isPerspectiveCamera&&(ot.fov=uh*2*Math.atan(1/ot.projectionMatrix.elements[5]),ot.zoom=1)}this.getCamera=function(){return b},this.getFoveation=function(){if(!(d===null&&p===null))return l},this.setFoveation=function(ot){l=ot,d!==null&&(d.fixedFoveation=ot),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=ot)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(b)};let gt=null;function xt(ot,ut){if(h=ut.getViewerPose(c||a),_=ut,h!==null){const _t=h.views;p!==null&&(t.setRenderTargetFramebuffer(M,p.framebuffer),t.setRenderTarget(M));let ht=!1;_t.length!==b.cameras.length&&(b.cameras.length=0,ht=!0);for(let zt=0;zt<_t.length;zt++){const Ut=_t[zt];let ce=null;if(p!==null)ce=p.getViewport(Ut);else{const he=u.getViewSubImage(d,Ut);ce=he.viewport,zt===0&&(t.setRenderTargetTextures(M,he.colorTexture,d.ignoreDepthValues?void 0:he.depthStencilTexture),t.setRenderTarget(M))}let Jt=E[zt];Jt===void 0&&(Jt=new Yn,Jt.layers.enable(zt),Jt.viewport=new We,E[zt]=Jt),Jt.matrix.fromArray(Ut.transform.matrix),Jt.matrix.decompose(Jt.position,Jt.quaternion,Jt.scale),Jt.projectionMatrix.fromArray(Ut.projectionMatrix),Jt.projectionMatrixInverse.copy(Jt.projectionMatrix).invert(),Jt.viewport.set(ce.x,ce.y,ce.width,ce.height),zt===0&&(b.matrix.copy(Jt.matrix),b.matrix.decompose(b.position,b.quaternion,b.scale)),ht===!0&&b.cameras.push(Jt)}const It=s.enabledFeatures;if(It&&It.includes("depth-sensing")){const zt=u.getDepthInformation(_t[0]);zt&&zt.isValid&&zt.texture&&g.init(t,zt,s.renderState)}}for(let _t=0;_t<S.length;_t++){const ht=x[_t],It=S[_t];ht!==null&&It!==void 0&&It.update(ht,ut,c||a)}gt&&gt(ot,ut),ut.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:ut}),_=null}const mt=new Om;mt.setAnimationLoop(xt),this.setAnimationLoop=function(ot){gt=ot},this.dispose=function(){}}}const Cs=new Ei,LD=new He;function ND(i,t){function e(m,f){m.matrixAutoUpdate===!0&&m.updateMatrix(),f.value.copy(m.matrix)}function n(m,f){f.color.getRGB(m.fogColor.value,Um(i)),f.isFog?(m.fogNear.value=f.near,m.fogFar.value=f.far):f.isFogExp2&&(m.fogDensity.value=f.density)}function s(m,f,M,S,x){f.isMeshBasicMaterial||f.isMeshLambertMaterial?o(m,f):f.isMeshToonMaterial?(o(m,f),u(m,f)):f.isMeshPhongMaterial?(o(m,f),h(m,f)):f.isMeshStandardMaterial?(o(m,f),d(m,f),f.isMeshPhysicalMaterial&&p(m,f,x)):f.isMeshMatcapMaterial?(o(m,f),_(m,f)):f.isMeshDepthMaterial?o(m,f):f.isMeshDistanceMaterial?(o(m,f),g(m,f)):f.isMeshNormalMaterial?o(m,f):f.isLineBasicMaterial?(a(m,f),f.isLineDashedMaterial&&r(m,f)):f.isPointsMaterial?l(m,f,M,S):f.isSpriteMaterial?c(m,f):f.isShadowMaterial?(m.color.value.copy(f.color),m.opacity.value=f.opacity):f.isShaderMaterial&&(f.uniformsNeedUpdate=!1)}function o(m,f){m.opacity.value=f.opacity,f.color&&m.diffuse.value.copy(f.color),f.emissive&&m.emissive.value.copy(f.emissive).multiplyScalar(f.emissiveIntensity),f.map&&(m.map.value=f.map,e(f.map,m.mapTransform)),f.alphaMap&&(m.alphaMap.value=f.alphaMap,e(f.alphaMap,m.alphaMapTransform)),f.bumpMap&&(m.bumpMap.value=f.bumpMap,e(f.bumpMap,m.bumpMapTransform),m.bumpScale.value=f.bumpScale,f.side===Pn&&(m.bumpScale.value*=-1)),f.normalMap&&(m.normalMap.value=f.normalMap,e(f.normalMap,m.normalMapTransform),m.normalScale.value.copy(f.normalScale),f.side===Pn&&m.normalScale.value.negate()),f.displacementMap&&(m.displacementMap.value=f.displacementMap,e(f.displacementMap,m.displacementMapTransform),m.displacementScale.value=f.displacementScale,m.displacementBias.value=f.displacementBias),f.emissiveMap&&(m.emissiveMap.value=f.emissiveMap,e(f.emissiveMap,m.emissiveMapTransform)),f.specularMap&&(m.specularMap.value=f.specularMap,e(f.specularMap,m.specularMapTransform)),f.alphaTest>0&&(m.alphaTest.value=f.alphaTest);const M=t.get(f),S=M.envMap,x=M.envMapRotation;S&&(m.envMap.value=S,Cs.copy(x),Cs.x*=-1,Cs.y*=-1,Cs.z*=-1,S.isCubeTexture&&S.isRenderTargetTexture===!1&&(Cs.y*=-1,Cs.z*=-1),m.envMapRotation.value.setFromMatrix4(LD.makeRotationFromEuler(Cs)),m.flipEnvMap.value=S.isCubeTexture&&S.isRenderTargetTexture===!1?-1:1,m.reflectivity.value=f.reflectivity,m.ior.value=f.ior,m.refractionRatio.value=f.refractionRatio),f.lightMap&&(m.lightMap.value=f.lightMap,m.lightMapIntensity.value=f.lightMapIntensity,e(f.lightMap,m.lightMapTransform)),f.aoMap&&(m.aoMap.value=f.aoMap,m.aoMapIntensity.value=f.aoMapIntensity,e(f.aoMap,m.aoMapTransform))}function a(m,f){m.diffuse.value.copy(f.color),m.opacity.value=f.opacity,f.map&&(m.map.value=f.map,e(f.map,m.mapTransform))}function r(m,f){m.dashSize.value=f.dashSize,m.totalSize.value=f.dashSize+f.gapSize,m.scale.value=f.scale}function l(m,f,M,S){m.diffuse.value.copy(f.color),m.opacity.value=f.opacity,m.size.value=f.size*M,m.scale.value=S*.5,f.map&&(m.map.value=f.map,e(f.map,m.uvTransform)),f.alphaMap&&(m.alphaMap.value=f.alphaMap,e(f.alphaMap,m.alphaMapTransform)),f.alphaTest>0&&(m.alphaTest.value=f.alphaTest)}function c(m,f){m.diffuse.value.copy(f.color),m.opacity.value=f.opacity,m.rotation.value=f.rotation,f.map&&(m.map.value=f.map,e(f.map,m.mapTransform)),f.alphaMap&&(m.alphaMap.value=f.alphaMap,e(f.alphaMap,m.alphaMapTransform)),f.alphaTest>0&&(m.alphaTest.value=f.alphaTest)}function h(m,f){m.specular.value.copy(f.specular),m.shininess.value=Math.max(f.shininess,1e-4)}function u(m,f){f.gradientMap&&(m.gradientMap.value=f.gradientMap)}function d(m,f){m.metalness.value=f.metalness,f.metalnessMap&&(m.metalnessMap.value=f.metalnessMap,e(f.metalnessMap,m.metalnessMapTransform)),m.roughness.value=f.roughness,f.roughnessMap&&(m.roughnessMap.value=f.roughnessMap,e(f.roughnessMap,m.roughnessMapTransform)),f.envMap&&(m.envMapIntensity.value=f.envMapIntensity)}function p(m,f,M){m.ior.value=f.ior,f.sheen>0&&(m.sheenColor.value.copy(f.sheenColor).multiplyScalar(f.sheen),m.sheenRoughness.value=f.sheenRoughness,f.sheenColorMap&&(m.sheenColorMap.value=f.sheenColorMap,e(f.sheenColorMap,m.sheenColorMapTransform)),f.sheenRoughnessMap&&(m.sheenRoughnessMap.value=f.sheenRoughnessMap,e(f.sheenRoughnessMap,m.sheenRoughnessMapTransform))),f.clearcoat>0&&(m.clearcoat.value=f.clearcoat,m.clearcoatRoughness.value=f.clearcoatRoughness,f.clearcoatMap&&(m.clearcoatMap.value=f.clearcoatMap,e(f.clearcoatMap,m.clearcoatMapTransform)),f.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=f.clearcoatRoughnessMap,e(f.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),f.clearcoatNormalMap&&(m.clearcoatNormalMap.value=f.clearcoatNormalMap,e(f.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(f.clearcoatNormalScale),f.side===Pn&&m.clearcoatNormalScale.value.negate())),f.dispersion>0&&(m.dispersion.value=f.dispersion),f.iridescence>0&&(m.iridescence.value=f.iridescence,m.iridescenceIOR.value=f.iridescenceIOR,m.iridescenceThicknessMinimum.value=f.iridescenceThicknessRange[0],m.iridescenceThicknessMaximum.value=f.iridescenceThicknessRange[1],f.iridescenceMap&&(m.iridescenceMap.value=f.iridescenceMap,e(f.iridescenceMap,m.iridescenceMapTransform)),f.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=f.iridescenceThicknessMap,e(f.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),f.transmission>0&&(m.transmission.value=f.transmission,m.transmissionSamplerMap.value=M.texture,m.transmissionSamplerSize.value.set(M.width,M.height),f.transmissionMap&&(m.transmissionMap.value=f.transmissionMap,e(f.transmissionMap,m.transmissionMapTransform)),m.thickness.value=f.thickness,f.thicknessMap&&(m.thicknessMap.value=f.thicknessMap,e(f.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=f.attenuationDistance,m.attenuationColor.value.copy(f.attenuationColor)),f.anisotropy>0&&(m.anisotropyVector.value.set(f.anisotropy*Math.cos(f.anisotropyRotation),f.anisotropy*Math.sin(f.anisotropyRotation)),f.anisotropyMap&&(m.anisotropyMap.value=f.anisotropyMap,e(f.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=f.specularIntensity,m.specularColor.value.copy(f.specularColor),f.specularColorMap&&(m.specularColorMap.value=f.specularColorMap,e(f.specularColorMap,m.specularColorMapTransform)),f.specularIntensityMap&&(m.specularIntensityMap.value=f.specularIntensityMap,e(f.specularIntensityMap,m.specularIntensityMapTransform))}function _(m,f){f.matcap&&(m.matcap.value=f.matcap)}function g(m,f){const M=t.get(f).light;m.referencePosition.value.setFromMatrixPosition(M.matrixWorld),m.nearDistance.value=M.shadow.camera.near,m.farDistance.value=M.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function DD(i,t,e,n){let s={},o={},a=[];const r=i.getParameter(i.MAX_UNIFORM_BUFFER_BINDINGS);function l(M,S){const x=S.program;n.uniformBlockBinding(M,x)}function c(M,S){let x=s[M.id];x===void 0&&(_(M),x=h(M),s[M.id]=x,M.addEventListener("dispose",m));const F=S.program;n.updateUBOMapping(M,F);const L=t.render.frame;o[M.id]!==L&&(d(M),o[M.id]=L)}function h(M){const S=u();M.__bindingPointIndex=S;const x=i.createBuffer(),F=M.__size,L=M.usage;return i.bindBuffer(i.UNIFORM_BUFFER,x),i.bufferData(i.UNIFORM_BUFFER,F,L),i.bindBuffer(i.UNIFORM_BUFFER,null),i.bindBufferBase(i.UNIFORM_BUFFER,S,x),x}function u(){for(let M=0;M<r;M++)if(a.indexOf(M)===-1)return a.push(M),M;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function d(M){const S=s[M.id],x=M.uniforms,F=M.__cache;i.bindBuffer(i.UNIFORM_BUFFER,S);for(let L=0,A=x.length;L<A;L++){const D=Array.isArray(x[L])?x[L]:[x[L]];for(let E=0,b=D.length;E<b;E++){const R=D[E];if(p(R,L,E,F)===!0){const H=R.__offset,O=Array.isArray(R.value)?R.value:[R.value];let q=0;for(let $=0;$<O.length;$++){const X=O[$],j=g(X);typeof X=="number"||typeof X=="boolean"?(R.__data[0]=X,i.bufferSubData(i.UNIFORM_BUFFER,H+q,R.__data)):X.isMatrix3?(R.__data[0]=X.elements[0],R.__data[1]=X.elements[1],R.__data[2]=X.elements[2],R.__data[3]=0,R.__data[4]=X.elements[3],R.__data[5]=X.elements[4],R.__data[6]=X.elements[5],R.__data[7]=0,R.__data[8]=X.elements[6],R.__data[9]=X.elements[7],R.__data[10]=X.elements[8],R.__data[11]=0):(X.toArray(R.__data,q),q+=j.storage/Float32Array.BYTES_PER_ELEMENT)}i.bufferSubData(i.UNIFORM_BUFFER,H,R.__data)}}}i.bindBuffer(i.UNIFORM_BUFFER,null)}function p(M,S,x,F){const L=M.value,A=S+"_"+x;if(F[A]===void 0)return typeof L=="number"||typeof L=="boolean"?F[A]=L:F[A]=L.clone(),!0;{const D=F[A];if(typeof L=="number"||typeof L=="boolean"){if(D!==L)return F[A]=L,!0}else if(D.equals(L)===!1)return D.copy(L),!0}return!1}function _(M){const S=M.uniforms;let x=0;const F=16;for(let A=0,D=S.length;A<D;A++){const E=Array.isArray(S[A])?S[A]:[S[A]];for(let b=0,R=E.length;b<R;b++){const H=E[b],O=Array.isArray(H.value)?H.value:[H.value];for(let q=0,$=O.length;q<$;q++){const X=O[q],j=g(X),Q=x%F,at=Q%j.boundary,lt=Q+at;x+=at,lt!==0&&F-lt<j.storage&&(x+=F-lt),H.__data=new Float32Array(j.storage/Float32Array.BYTES_PER_ELEMENT),H.__offset=x,x+=j.storage}}}const L=x%F;return L>0&&(x+=F-L),M.__size=x,M.__cache={},this}function g(M){const S={boundary:0,storage:0};return typeof M=="number"||typeof M=="boolean"?(S.boundary=4,S.storage=4):M.isVector2?(S.boundary=8,S.storage=8):M.isVector3||M.isColor?(S.boundary=16,S.storage=12):M.isVector4?(S.boundary=16,S.storage=16):M.isMatrix3?(S.boundary=48,S.storage=48):M.isMatrix4?(S.boundary=64,S.storage=64):M.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",M),S}function m(M){const S=M.target;S.removeEventListener("dispose",m);const x=a.indexOf(S.__bindingPointIndex);a.splice(x,1),i.deleteBuffer(s[S.id]),delete s[S.id],delete o[S.id]}function f(){for(const M in s)i.deleteBuffer(s[M]);a=[],s={},o={}}return{bind:l,update:c,dispose:f}}class ID{constructor(t={}){const{canvas:e=MC(),context:n=null,depth:s=!0,stencil:o=!1,alpha:a=!1,antialias:r=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reverseDepthBuffer:d=!1}=t;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=a;const _=new Uint32Array(4),g=new Int32Array(4);let m=null,f=null;const M=[],S=[];this.domElement=e,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this._outputColorSpace=Bn,this.toneMapping=hs,this.toneMappingExposure=1;const x=this;let F=!1,L=0,A=0,D=null,E=-1,b=null;const R=new We,H=new We;let O=null;const q=new de(0);let $=0,X=e.width,j=e.height,Q=1,at=null,lt=null;const gt=new We(0,0,X,j),xt=new We(0,0,X,j);let mt=!1;const ot=new Zh;let ut=!1,_t=!1;const ht=new He,It=new He,zt=new et,Ut=new We,ce={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0};let Jt=!1;function he(){return D===null?Q:1}let G=n;function je(T,z){return e.getContext(T,z)}try{const T={alpha:!0,depth:s,stencil:o,antialias:r,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${Hh}`),e.addEventListener("webglcontextlost",ct,!1),e.addEventListener("webglcontextrestored",Rt,!1),e.addEventListener("webglcontextcreationerror",Ct,!1),G===null){const z="webgl2";if(G=je(z,T),G===null)throw je(z)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(T){throw console.error("THREE.WebGLRenderer: "+T.message),T}let ee,ie,Wt,fe,Nt,N,w,tt,nt,Y,it,St,bt,At,Zt,pt,yt,Ot,Ht,Et,oe,Yt,pe,V;function Mt(){ee=new BL(G),ee.init(),Yt=new wD(G,ee),ie=new DL(G,ee,t,Yt),Wt=new yD(G,ee),ie.reverseDepthBuffer&&d&&Wt.buffers.depth.setReversed(!0),fe=new VL(G),Nt=new rD,N=new SD(G,ee,Wt,Nt,ie,Yt,fe),w=new UL(x),tt=new OL(x),nt=new YC(G),pe=new LL(G,nt),Y=new zL(G,nt,fe,pe),it=new WL(G,Y,nt,fe),Ht=new GL(G,ie,N),pt=new IL(Nt),St=new oD(x,w,tt,ee,ie,pe,pt),bt=new ND(x,Nt),At=new lD,Zt=new pD(ee),Ot=new PL(x,w,tt,Wt,it,p,l),yt=new xD(x,it,ie),V=new DD(G,fe,ie,Wt),Et=new NL(G,ee,fe),oe=new HL(G,ee,fe),fe.programs=St.programs,x.capabilities=ie,x.extensions=ee,x.properties=Nt,x.renderLists=At,x.shadowMap=yt,x.state=Wt,x.info=fe}Mt();const st=new PD(x,G);this.xr=st,this.getContext=function(){return G},this.getContextAttributes=function(){return G.getContextAttributes()},this.forceContextLoss=function(){const T=ee.get("WEBGL_lose_context");T&&T.loseContext()},this.forceContextRestore=function(){const T=ee.get("WEBGL_lose_context");T&&T.restoreContext()},this.getPixelRatio=function(){return Q},this.setPixelRatio=function(T){T!==void 0&&(Q=T,this.setSize(X,j,!1))},this.getSize=function(T){return T.set(X,j)},this.setSize=function(T,z,K=!0){if(st.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}X=T,j=z,e.width=Math.floor(T*Q),e.height=Math.floor(z*Q),K===!0&&(e.style.width=T+"px",e.style.height=z+"px"),this.setViewport(0,0,T,z)},this.getDrawingBufferSize=function(T){return T.set(X*Q,j*Q).floor()},this.setDrawingBufferSize=function(T,z,K){X=T,j=z,Q=K,e.width=Math.floor(T*K),e.height=Math.floor(z*K),this.setViewport(0,0,T,z)},this.getCurrentViewport=function(T){return T.copy(R)},this.getViewport=function(T){return T.copy(gt)},this.setViewport=function(T,z,K,Z){T.isVector4?gt.set(T.x,T.y,T.z,T.w):gt.set(T,z,K,Z),Wt.viewport(R.copy(gt).multiplyScalar(Q).round())},this.getScissor=function(T){return T.copy(xt)},this.setScissor=function(T,z,K,Z){T.isVector4?xt.set(T.x,T.y,T.z,T.w):xt.set(T,z,K,Z),Wt.scissor(H.copy(xt).multiplyScalar(Q).round())},this.getScissorTest=function(){return mt},this.setScissorTest=function(T){Wt.setScissorTest(mt=T)},this.setOpaqueSort=function(T){at=T},this.setTransparentSort=function(T){lt=T},this.getClearColor=function(T){return T.copy(Ot.getClearColor())},this.setClearColor=function(){Ot.setClearColor.apply(Ot,arguments)},this.getClearAlpha=function(){return Ot.getClearAlpha()},this.setClearAlpha=function(){Ot.setClearAlpha.apply(Ot,arguments)},this.clear=function(T=!0,z=!0,K=!0){let Z=0;if(T){let W=!1;if(D!==null){const ft=D.texture.format;W=ft===Xh||ft===qh||ft===$h}if(W){const ft=D.texture.type,wt=ft===$i||ft===Xs||ft===Tr||ft===Go||ft===Gh||ft===Wh,Bt=Ot.getClearColor(),kt=Ot.getClearAlpha(),$t=Bt.r,jt=Bt.g,Ft=Bt.b;wt?(_[0]=$t,_[1]=jt,_[2]=Ft,_[3]=kt,G.clearBufferuiv(G.COLOR,0,_)):(g[0]=$t,g[1]=jt,g[2]=Ft,g[3]=kt,G.clearBufferiv(G.COLOR,0,g))}else Z|=G.COLOR_BUFFER_BIT}z&&(Z|=G.DEPTH_BUFFER_BIT),K&&(Z|=G.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),G.clear(Z)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){e.removeEventListener("webglcontextlost",ct,!1),e.removeEventListener("webglcontextrestored",Rt,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),At.dispose(),Zt.dispose(),Nt.dispose(),w.dispose(),tt.dispose(),it.dispose(),pe.dispose(),V.dispose(),St.dispose(),st.dispose(),st.removeEventListener("sessionstart",Ln),st.removeEventListener("sessionend",Ti),Tn.stop()};function ct(T){T.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),F=!0}function Rt(){console.log("THREE.WebGLRenderer: Context Restored."),F=!1;const T=fe.autoReset,z=yt.enabled,K=yt.autoUpdate,Z=yt.needsUpdate,W=yt.type;Mt(),fe.autoReset=T,yt.enabled=z,yt.autoUpdate=K,yt.needsUpdate=Z,yt.type=W}function Ct(T){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",T.statusMessage)}function Qt(T){const z=T.target;z.removeEventListener("dispose",Qt),Fe(z)}function Fe(T){nn(T),Nt.remove(T)}function nn(T){const z=Nt.get(T).programs;z!==void 0&&(z.forEach(function(K){St.releaseProgram(K)}),T.isShaderMaterial&&St.releaseShaderCache(T))}this.renderBufferDirect=function(T,z,K,Z,W,ft){z===null&&(z=ce);const wt=W.isMesh&&W.matrixWorld.determinant()<0,Bt=sl(T,z,K,Z,W);Wt.setMaterial(Z,wt);let kt=K.index,$t=1;if(Z.wireframe===!0){if(kt=Y.getWireframeAttribute(K),kt===void 0)return;$t=2}const jt=K.drawRange,Ft=K.attributes.position;let ae=jt.start*$t,we=(jt.start+jt.count)*$t;ft!==null&&(ae=Math.max(ae,ft.start*$t),we=Math.min(we,(ft.start+ft.count)*$t)),kt!==null?(ae=Math.max(ae,0),we=Math.min(we,kt.count)):Ft!=null&&(ae=Math.max(ae,0),we=Math.min(we,Ft.count));const Te=we-ae;if(Te<0||Te===1/0)return;pe.setup(W,Z,Bt,K,kt);let sn,ue=Et;if(kt!==null&&(sn=nt.get(kt),ue=oe,ue.setIndex(sn)),W.isMesh)Z.wireframe===!0?(Wt.setLineWidth(Z.wireframeLinewidth*he()),ue.setMode(G.LINES)):ue.setMode(G.TRIANGLES);else if(W.isLine){let Vt=Z.linewidth;Vt===void 0&&(Vt=1),Wt.setLineWidth(Vt*he()),W.isLineSegments?ue.setMode(G.LINES):W.isLineLoop?ue.setMode(G.LINE_LOOP):ue.setMode(G.LINE_STRIP)}else W.isPoints?ue.setMode(G.POINTS):W.isSprite&&ue.setMode(G.TRIANGLES);if(W.isBatchedMesh)if(W._multiDrawInstances!==null)ue.renderMultiDrawInstances(W._multiDrawStarts,W._multiDrawCounts,W._multiDrawCount,W._multiDrawInstances);else if(ee.get("WEBGL_multi_draw"))ue.renderMultiDraw(W._multiDrawStarts,W._multiDrawCounts,W._multiDrawCount);else{const Vt=W._multiDrawStarts,Oe=W._multiDrawCounts,me=W._multiDrawCount,An=kt?nt.get(kt).bytesPerElement:1,ui=Nt.get(Z).currentProgram.getUniforms();for(let mn=0;mn<me;mn++)ui.setValue(G,"_gl_DrawID",mn),ue.render(Vt[mn]/An,Oe[mn])}else if(W.isInstancedMesh)ue.renderInstances(ae,Te,W.count);else if(K.isInstancedBufferGeometry){const Vt=K._maxInstanceCount!==void 0?K._maxInstanceCount:1/0,Oe=Math.min(K.instanceCount,Vt);ue.renderInstances(ae,Te,Oe)}else ue.render(ae,Te)};function ye(T,z,K){T.transparent===!0&&T.side===Fi&&T.forceSinglePass===!1?(T.side=Pn,T.needsUpdate=!0,Js(T,z,K),T.side=ms,T.needsUpdate=!0,Js(T,z,K),T.side=Fi):Js(T,z,K)}this.compile=function(T,z,K=null){K===null&&(K=T),f=Zt.get(K),f.init(z),S.push(f),K.traverseVisible(function(W){W.isLight&&W.layers.test(z.layers)&&(f.pushLight(W),W.castShadow&&f.pushShadow(W))}),T!==K&&T.traverseVisible(function(W){W.isLight&&W.layers.test(z.layers)&&(f.pushLight(W),W.castShadow&&f.pushShadow(W))}),f.setupLights();const Z=new Set;return T.traverse(function(W){if(!(W.isMesh||W.isPoints||W.isLine||W.isSprite))return;const ft=W.material;if(ft)if(Array.isArray(ft))for(let wt=0;wt<ft.length;wt++){const Bt=ft[wt];ye(Bt,K,W),Z.add(Bt)}else ye(ft,K,W),Z.add(ft)}),S.pop(),f=null,Z},this.compileAsync=function(T,z,K=null){const Z=this.compile(T,z,K);return new Promise(W=>{function ft(){if(Z.forEach(function(wt){Nt.get(wt).currentProgram.isReady()&&Z.delete(wt)}),Z.size===0){W(T);return}setTimeout(ft,10)}ee.get("KHR_parallel_shader_compile")!==null?ft():setTimeout(ft,10)})};let Ye=null;function Ne(T){Ye&&Ye(T)}function Ln(){Tn.stop()}function Ti(){Tn.start()}const Tn=new Om;Tn.setAnimationLoop(Ne),typeof self<"u"&&Tn.setContext(self),this.setAnimationLoop=function(T){Ye=T,st.setAnimationLoop(T),T===null?Tn.stop():Tn.start()},st.addEventListener("sessionstart",Ln),st.addEventListener("sessionend",Ti),this.render=function(T,z){if(z!==void 0&&z.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(F===!0)return;if(T.matrixWorldAutoUpdate===!0&&T.updateMatrixWorld(),z.parent===null&&z.matrixWorldAutoUpdate===!0&&z.updateMatrixWorld(),st.enabled===!0&&st.isPresenting===!0&&(st.cameraAutoUpdate===!0&&st.updateCamera(z),z=st.getCamera()),T.isScene===!0&&T.onBeforeRender(x,T,z,D),f=Zt.get(T,S.length),f.init(z),S.push(f),It.multiplyMatrices(z.projectionMatrix,z.matrixWorldInverse),ot.setFromProjectionMatrix(It),_t=this.localClippingEnabled,ut=pt.init(this.clippingPlanes,_t),m=At.get(T,M.length),m.init(),M.push(m),st.enabled===!0&&st.isPresenting===!0){const ft=x.xr.getDepthSensingMesh();ft!==null&&pn(ft,z,-1/0,x.sortObjects)}pn(T,z,0,x.sortObjects),m.finish(),x.sortObjects===!0&&m.sort(at,lt),Jt=st.enabled===!1||st.isPresenting===!1||st.hasDepthSensing()===!1,Jt&&Ot.addToRenderList(m,T),this.info.render.frame++,ut===!0&&pt.beginShadows();const K=f.state.shadowsArray;yt.render(K,T,z),ut===!0&&pt.endShadows(),this.info.autoReset===!0&&this.info.reset();const Z=m.opaque,W=m.transmissive;if(f.setupLights(),z.isArrayCamera){const ft=z.cameras;if(W.length>0)for(let wt=0,Bt=ft.length;wt<Bt;wt++){const kt=ft[wt];Ri(Z,W,T,kt)}Jt&&Ot.render(T);for(let wt=0,Bt=ft.length;wt<Bt;wt++){const kt=ft[wt];Ai(m,T,kt,kt.viewport)}}else W.length>0&&Ri(Z,W,T,z),Jt&&Ot.render(T),Ai(m,T,z);D!==null&&(N.updateMultisampleRenderTarget(D),N.updateRenderTargetMipmap(D)),T.isScene===!0&&T.onAfterRender(x,T,z),pe.resetDefaultState(),E=-1,b=null,S.pop(),S.length>0?(f=S[S.length-1],ut===!0&&pt.setGlobalState(x.clippingPlanes,f.state.camera)):f=null,M.pop(),M.length>0?m=M[M.length-1]:m=null};function pn(T,z,K,Z){if(T.visible===!1)return;if(T.layers.test(z.layers)){if(T.isGroup)K=T.renderOrder;else if(T.isLOD)T.autoUpdate===!0&&T.update(z);else if(T.isLight)f.pushLight(T),T.castShadow&&f.pushShadow(T);else if(T.isSprite){if(!T.frustumCulled||ot.intersectsSprite(T)){Z&&Ut.setFromMatrixPosition(T.matrixWorld).applyMatrix4(It);const wt=it.update(T),Bt=T.material;Bt.visible&&m.push(T,wt,Bt,K,Ut.z,null)}}else if((T.isMesh||T.isLine||T.isPoints)&&(!T.frustumCulled||ot.intersectsObject(T))){const wt=it.update(T),Bt=T.material;if(Z&&(T.boundingSphere!==void 0?(T.boundingSphere===null&&T.computeBoundingSphere(),Ut.copy(T.boundingSphere.center)):(wt.boundingSphere===null&&wt.computeBoundingSphere(),Ut.copy(wt.boundingSphere.center)),Ut.applyMatrix4(T.matrixWorld).applyMatrix4(It)),Array.isArray(Bt)){const kt=wt.groups;for(let $t=0,jt=kt.length;$t<jt;$t++){const Ft=kt[$t],ae=Bt[Ft.materialIndex];ae&&ae.visible&&m.push(T,wt,ae,K,Ut.z,Ft)}}else Bt.visible&&m.push(T,wt,Bt,K,Ut.z,null)}}const ft=T.children;for(let wt=0,Bt=ft.length;wt<Bt;wt++)pn(ft[wt],z,K,Z)}function Ai(T,z,K,Z){const W=T.opaque,ft=T.transmissive,wt=T.transparent;f.setupLightsView(K),ut===!0&&pt.setGlobalState(x.clippingPlanes,K),Z&&Wt.viewport(R.copy(Z)),W.length>0&&vs(W,z,K),ft.length>0&&vs(ft,z,K),wt.length>0&&vs(wt,z,K),Wt.buffers.depth.setTest(!0),Wt.buffers.depth.setMask(!0),Wt.buffers.color.setMask(!0),Wt.setPolygonOffset(!1)}function Ri(T,z,K,Z){if((K.isScene===!0?K.overrideMaterial:null)!==null)return;f.state.transmissionRenderTarget[Z.id]===void 0&&(f.state.transmissionRenderTarget[Z.id]=new js(1,1,{generateMipmaps:!0,type:ee.has("EXT_color_buffer_half_float")||ee.has("EXT_color_buffer_float")?Rr:$i,minFilter:Bs,samples:4,stencilBuffer:o,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:ge.workingColorSpace}));const ft=f.state.transmissionRenderTarget[Z.id],wt=Z.viewport||R;ft.setSize(wt.z,wt.w);const Bt=x.getRenderTarget();x.setRenderTarget(ft),x.getClearColor(q),$=x.getClearAlpha(),$<1&&x.setClearColor(16777215,.5),x.clear(),Jt&&Ot.render(K);const kt=x.toneMapping;x.toneMapping=hs;const $t=Z.viewport;if(Z.viewport!==void 0&&(Z.viewport=void 0),f.setupLightsView(Z),ut===!0&&pt.setGlobalState(x.clippingPlanes,Z),vs(T,K,Z),N.updateMultisampleRenderTarget(ft),N.updateRenderTargetMipmap(ft),ee.has("WEBGL_multisampled_render_to_texture")===!1){let jt=!1;for(let Ft=0,ae=z.length;Ft<ae;Ft++){const we=z[Ft],Te=we.object,sn=we.geometry,ue=we.material,Vt=we.group;if(ue.side===Fi&&Te.layers.test(Z.layers)){const Oe=ue.side;ue.side=Pn,ue.needsUpdate=!0,er(Te,K,Z,sn,ue,Vt),ue.side=Oe,ue.needsUpdate=!0,jt=!0}}jt===!0&&(N.updateMultisampleRenderTarget(ft),N.updateRenderTargetMipmap(ft))}x.setRenderTarget(Bt),x.setClearColor(q,$),$t!==void 0&&(Z.viewport=$t),x.toneMapping=kt}function vs(T,z,K){const Z=z.isScene===!0?z.overrideMaterial:null;for(let W=0,ft=T.length;W<ft;W++){const wt=T[W],Bt=wt.object,kt=wt.geometry,$t=Z===null?wt.material:Z,jt=wt.group;Bt.layers.test(K.layers)&&er(Bt,z,K,kt,$t,jt)}}function er(T,z,K,Z,W,ft){T.onBeforeRender(x,z,K,Z,W,ft),T.modelViewMatrix.multiplyMatrices(K.matrixWorldInverse,T.matrixWorld),T.normalMatrix.getNormalMatrix(T.modelViewMatrix),W.onBeforeRender(x,z,K,Z,T,ft),W.transparent===!0&&W.side===Fi&&W.forceSinglePass===!1?(W.side=Pn,W.needsUpdate=!0,x.renderBufferDirect(K,z,Z,W,T,ft),W.side=ms,W.needsUpdate=!0,x.renderBufferDirect(K,z,Z,W,T,ft),W.side=Fi):x.renderBufferDirect(K,z,Z,W,T,ft),T.onAfterRender(x,z,K,Z,W,ft)}function Js(T,z,K){z.isScene!==!0&&(z=ce);const Z=Nt.get(T),W=f.state.lights,ft=f.state.shadowsArray,wt=W.state.version,Bt=St.getParameters(T,W.state,ft,z,K),kt=St.getProgramCacheKey(Bt);let $t=Z.programs;Z.environment=T.isMeshStandardMaterial?z.environment:null,Z.fog=z.fog,Z.envMap=(T.isMeshStandardMaterial?tt:w).get(T.envMap||Z.environment),Z.envMapRotation=Z.environment!==null&&T.envMap===null?z.environmentRotation:T.envMapRotation,$t===void 0&&(T.addEventListener("dispose",Qt),$t=new Map,Z.programs=$t);let jt=$t.get(kt);if(jt!==void 0){if(Z.currentProgram===jt&&Z.lightsStateVersion===wt)return hi(T,Bt),jt}else Bt.uniforms=St.getUniforms(T),T.onBeforeCompile(Bt,x),jt=St.acquireProgram(Bt,kt),$t.set(kt,jt),Z.uniforms=Bt.uniforms;const Ft=Z.uniforms;return(!T.isShaderMaterial&&!T.isRawShaderMaterial||T.clipping===!0)&&(Ft.clippingPlanes=pt.uniform),hi(T,Bt),Z.needsLights=Ur(T),Z.lightsStateVersion=wt,Z.needsLights&&(Ft.ambientLightColor.value=W.state.ambient,Ft.lightProbe.value=W.state.probe,Ft.directionalLights.value=W.state.directional,Ft.directionalLightShadows.value=W.state.directionalShadow,Ft.spotLights.value=W.state.spot,Ft.spotLightShadows.value=W.state.spotShadow,Ft.rectAreaLights.value=W.state.rectArea,Ft.ltc_1.value=W.state.rectAreaLTC1,Ft.ltc_2.value=W.state.rectAreaLTC2,Ft.pointLights.value=W.state.point,Ft.pointLightShadows.value=W.state.pointShadow,Ft.hemisphereLights.value=W.state.hemi,Ft.directionalShadowMap.value=W.state.directionalShadowMap,Ft.directionalShadowMatrix.value=W.state.directionalShadowMatrix,Ft.spotShadowMap.value=W.state.spotShadowMap,Ft.spotLightMatrix.value=W.state.spotLightMatrix,Ft.spotLightMap.value=W.state.spotLightMap,Ft.pointShadowMap.value=W.state.pointShadowMap,Ft.pointShadowMatrix.value=W.state.pointShadowMatrix),Z.currentProgram=jt,Z.uniformsList=null,jt}function Ir(T){if(T.uniformsList===null){const z=T.currentProgram.getUniforms();T.uniformsList=Aa.seqWithValue(z.seq,T.uniforms)}return T.uniformsList}function hi(T,z){const K=Nt.get(T);K.outputColorSpace=z.outputColorSpace,K.batching=z.batching,K.batchingColor=z.batchingColor,K.instancing=z.instancing,K.instancingColor=z.instancingColor,K.instancingMorph=z.instancingMorph,K.skinning=z.skinning,K.morphTargets=z.morphTargets,K.morphNormals=z.morphNormals,K.morphColors=z.morphColors,K.morphTargetsCount=z.morphTargetsCount,K.numClippingPlanes=z.numClippingPlanes,K.numIntersection=z.numClipIntersection,K.vertexAlphas=z.vertexAlphas,K.vertexTangents=z.vertexTangents,K.toneMapping=z.toneMapping}function sl(T,z,K,Z,W){z.isScene!==!0&&(z=ce),N.resetTextureUnits();const ft=z.fog,wt=Z.isMeshStandardMaterial?z.environment:null,Bt=D===null?x.outputColorSpace:D.isXRRenderTarget===!0?D.texture.colorSpace:Zo,kt=(Z.isMeshStandardMaterial?tt:w).get(Z.envMap||wt),$t=Z.vertexColors===!0&&!!K.attributes.color&&K.attributes.color.itemSize===4,jt=!!K.attributes.tangent&&(!!Z.normalMap||Z.anisotropy>0),Ft=!!K.morphAttributes.position,ae=!!K.morphAttributes.normal,we=!!K.morphAttributes.color;let Te=hs;Z.toneMapped&&(D===null||D.isXRRenderTarget===!0)&&(Te=x.toneMapping);const sn=K.morphAttributes.position||K.morphAttributes.normal||K.morphAttributes.color,ue=sn!==void 0?sn.length:0,Vt=Nt.get(Z),Oe=f.state.lights;if(ut===!0&&(_t===!0||T!==b)){const xn=T===b&&Z.id===E;pt.setState(Z,T,xn)}let me=!1;Z.version===Vt.__version?(Vt.needsLights&&Vt.lightsStateVersion!==Oe.state.version||Vt.outputColorSpace!==Bt||W.isBatchedMesh&&Vt.batching===!1||!W.isBatchedMesh&&Vt.batching===!0||W.isBatchedMesh&&Vt.batchingColor===!0&&W.colorTexture===null||W.isBatchedMesh&&Vt.batchingColor===!1&&W.colorTexture!==null||W.isInstancedMesh&&Vt.instancing===!1||!W.isInstancedMesh&&Vt.instancing===!0||W.isSkinnedMesh&&Vt.skinning===!1||!W.isSkinnedMesh&&Vt.skinning===!0||W.isInstancedMesh&&Vt.instancingColor===!0&&W.instanceColor===null||W.isInstancedMesh&&Vt.instancingColor===!1&&W.instanceColor!==null||W.isInstancedMesh&&Vt.instancingMorph===!0&&W.morphTexture===null||W.isInstancedMesh&&Vt.instancingMorph===!1&&W.morphTexture!==null||Vt.envMap!==kt||Z.fog===!0&&Vt.fog!==ft||Vt.numClippingPlanes!==void 0&&(Vt.numClippingPlanes!==pt.numPlanes||Vt.numIntersection!==pt.numIntersection)||Vt.vertexAlphas!==$t||Vt.vertexTangents!==jt||Vt.morphTargets!==Ft||Vt.morphNormals!==ae||Vt.morphColors!==we||Vt.toneMapping!==Te||Vt.morphTargetsCount!==ue)&&(me=!0):(me=!0,Vt.__version=Z.version);let An=Vt.currentProgram;me===!0&&(An=Js(Z,z,W));let ui=!1,mn=!1,bs=!1;const Ce=An.getUniforms(),Vn=Vt.uniforms;if(Wt.useProgram(An.program)&&(ui=!0,mn=!0,bs=!0),Z.id!==E&&(E=Z.id,mn=!0),ui||b!==T){Wt.buffers.depth.getReversed()?(ht.copy(T.projectionMatrix),wC(ht),EC(ht),Ce.setValue(G,"projectionMatrix",ht)):Ce.setValue(G,"projectionMatrix",T.projectionMatrix),Ce.setValue(G,"viewMatrix",T.matrixWorldInverse);const di=Ce.map.cameraPosition;di!==void 0&&di.setValue(G,zt.setFromMatrixPosition(T.matrixWorld)),ie.logarithmicDepthBuffer&&Ce.setValue(G,"logDepthBufFC",2/(Math.log(T.far+1)/Math.LN2)),(Z.isMeshPhongMaterial||Z.isMeshToonMaterial||Z.isMeshLambertMaterial||Z.isMeshBasicMaterial||Z.isMeshStandardMaterial||Z.isShaderMaterial)&&Ce.setValue(G,"isOrthographic",T.isOrthographicCamera===!0),b!==T&&(b=T,mn=!0,bs=!0)}if(W.isSkinnedMesh){Ce.setOptional(G,W,"bindMatrix"),Ce.setOptional(G,W,"bindMatrixInverse");const xn=W.skeleton;xn&&(xn.boneTexture===null&&xn.computeBoneTexture(),Ce.setValue(G,"boneTexture",xn.boneTexture,N))}W.isBatchedMesh&&(Ce.setOptional(G,W,"batchingTexture"),Ce.setValue(G,"batchingTexture",W._matricesTexture,N),Ce.setOptional(G,W,"batchingIdTexture"),Ce.setValue(G,"batchingIdTexture",W._indirectTexture,N),Ce.setOptional(G,W,"batchingColorTexture"),W._colorsTexture!==null&&Ce.setValue(G,"batchingColorTexture",W._colorsTexture,N));const qi=K.morphAttributes;if((qi.position!==void 0||qi.normal!==void 0||qi.color!==void 0)&&Ht.update(W,K,An),(mn||Vt.receiveShadow!==W.receiveShadow)&&(Vt.receiveShadow=W.receiveShadow,Ce.setValue(G,"receiveShadow",W.receiveShadow)),Z.isMeshGouraudMaterial&&Z.envMap!==null&&(Vn.envMap.value=kt,Vn.flipEnvMap.value=kt.isCubeTexture&&kt.isRenderTargetTexture===!1?-1:1),Z.isMeshStandardMaterial&&Z.envMap===null&&z.environment!==null&&(Vn.envMapIntensity.value=z.environmentIntensity),mn&&(Ce.setValue(G,"toneMappingExposure",x.toneMappingExposure),Vt.needsLights&&xs(Vn,bs),ft&&Z.fog===!0&&bt.refreshFogUniforms(Vn,ft),bt.refreshMaterialUniforms(Vn,Z,Q,j,f.state.transmissionRenderTarget[T.id]),Aa.upload(G,Ir(Vt),Vn,N)),Z.isShaderMaterial&&Z.uniformsNeedUpdate===!0&&(Aa.upload(G,Ir(Vt),Vn,N),Z.uniformsNeedUpdate=!1),Z.isSpriteMaterial&&Ce.setValue(G,"center",W.center),Ce.setValue(G,"modelViewMatrix",W.modelViewMatrix),Ce.setValue(G,"normalMatrix",W.normalMatrix),Ce.setValue(G,"modelMatrix",W.matrixWorld),Z.isShaderMaterial||Z.isRawShaderMaterial){const xn=Z.uniformsGroups;for(let di=0,Zn=xn.length;di<Zn;di++){const Qs=xn[di];V.update(Qs,An),V.bind(Qs,An)}}return An}function xs(T,z){T.ambientLightColor.needsUpdate=z,T.lightProbe.needsUpdate=z,T.directionalLights.needsUpdate=z,T.directionalLightShadows.needsUpdate=z,T.pointLights.needsUpdate=z,T.pointLightShadows.needsUpdate=z,T.spotLights.needsUpdate=z,T.spotLightShadows.needsUpdate=z,T.rectAreaLights.needsUpdate=z,T.hemisphereLights.needsUpdate=z}function Ur(T){return T.isMeshLambertMaterial||T.isMeshToonMaterial||T.isMeshPhongMaterial||T.isMeshStandardMaterial||T.isShadowMaterial||T.isShaderMaterial&&T.lights===!0}this.getActiveCubeFace=function(){return L},this.getActiveMipmapLevel=function(){return A},this.getRenderTarget=function(){return D},this.setRenderTargetTextures=function(T,z,K){Nt.get(T.texture).__webglTexture=z,Nt.get(T.depthTexture).__webglTexture=K;const Z=Nt.get(T);Z.__hasExternalTextures=!0,Z.__autoAllocateDepthBuffer=K===void 0,Z.__autoAllocateDepthBuffer||ee.has("WEBGL_multisampled_render_to_texture")===!0&&(console.warn("THREE.WebGLRenderer: Render-to-texture extension was disabled because an external texture was provided"),Z.__useRenderToTexture=!1)},this.setRenderTargetFramebuffer=function(T,z){const K=Nt.get(T);K.__webglFramebuffer=z,K.__useDefaultFramebuffer=z===void 0},this.setRenderTarget=function(T,z=0,K=0){D=T,L=z,A=K;let Z=!0,W=null,ft=!1,wt=!1;if(T){const kt=Nt.get(T);if(kt.__useDefaultFramebuffer!==void 0)Wt.bindFramebuffer(G.FRAMEBUFFER,null),Z=!1;else if(kt.__webglFramebuffer===void 0)N.setupRenderTarget(T);else if(kt.__hasExternalTextures)N.rebindTextures(T,Nt.get(T.texture).__webglTexture,Nt.get(T.depthTexture).__webglTexture);else if(T.depthBuffer){const Ft=T.depthTexture;if(kt.__boundDepthTexture!==Ft){if(Ft!==null&&Nt.has(Ft)&&(T.width!==Ft.image.width||T.height!==Ft.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");N.setupDepthRenderbuffer(T)}}const $t=T.texture;($t.isData3DTexture||$t.isDataArrayTexture||$t.isCompressedArrayTexture)&&(wt=!0);const jt=Nt.get(T).__webglFramebuffer;T.isWebGLCubeRenderTarget?(Array.isArray(jt[z])?W=jt[z][K]:W=jt[z],ft=!0):T.samples>0&&N.useMultisampledRTT(T)===!1?W=Nt.get(T).__webglMultisampledFramebuffer:Array.isArray(jt)?W=jt[K]:W=jt,R.copy(T.viewport),H.copy(T.scissor),O=T.scissorTest}else R.copy(gt).multiplyScalar(Q).floor(),H.copy(xt).multiplyScalar(Q).floor(),O=mt;if(Wt.bindFramebuffer(G.FRAMEBUFFER,W)&&Z&&Wt.drawBuffers(T,W),Wt.viewport(R),Wt.scissor(H),Wt.setScissorTest(O),ft){const kt=Nt.get(T.texture);G.framebufferTexture2D(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_CUBE_MAP_POSITIVE_X+z,kt.__webglTexture,K)}else if(wt){const kt=Nt.get(T.texture),$t=z||0;G.framebufferTextureLayer(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0,kt.__webglTexture,K||0,$t)}E=-1},this.readRenderTargetPixels=function(T,z,K,Z,W,ft,wt){if(!(T&&T.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Bt=Nt.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&wt!==void 0&&(Bt=Bt[wt]),Bt){Wt.bindFramebuffer(G.FRAMEBUFFER,Bt);try{const kt=T.texture,$t=kt.format,jt=kt.type;if(!ie.textureFormatReadable($t)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!ie.textureTypeReadable(jt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}z>=0&&z<=T.width-Z&&K>=0&&K<=T.height-W&&G.readPixels(z,K,Z,W,Yt.convert($t),Yt.convert(jt),ft)}finally{const kt=D!==null?Nt.get(D).__webglFramebuffer:null;Wt.bindFramebuffer(G.FRAMEBUFFER,kt)}}},this.readRenderTargetPixelsAsync=async function(T,z,K,Z,W,ft,wt){if(!(T&&T.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Bt=Nt.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&wt!==void 0&&(Bt=Bt[wt]),Bt){const kt=T.texture,$t=kt.format,jt=kt.type;if(!ie.textureFormatReadable($t))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!ie.textureTypeReadable(jt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");if(z>=0&&z<=T.width-Z&&K>=0&&K<=T.height-W){Wt.bindFramebuffer(G.FRAMEBUFFER,Bt);const Ft=G.createBuffer();G.bindBuffer(G.PIXEL_PACK_BUFFER,Ft),G.bufferData(G.PIXEL_PACK_BUFFER,ft.byteLength,G.STREAM_READ),G.readPixels(z,K,Z,W,Yt.convert($t),Yt.convert(jt),0);const ae=D!==null?Nt.get(D).__webglFramebuffer:null;Wt.bindFramebuffer(G.FRAMEBUFFER,ae);const we=G.fenceSync(G.SYNC_GPU_COMMANDS_COMPLETE,0);return G.flush(),await SC(G,we,4),G.bindBuffer(G.PIXEL_PACK_BUFFER,Ft),G.getBufferSubData(G.PIXEL_PACK_BUFFER,0,ft),G.deleteBuffer(Ft),G.deleteSync(we),ft}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")}},this.copyFramebufferToTexture=function(T,z=null,K=0){T.isTexture!==!0&&(vr("WebGLRenderer: copyFramebufferToTexture function signature has changed."),z=arguments[0]||null,T=arguments[1]);const Z=Math.pow(2,-K),W=Math.floor(T.image.width*Z),ft=Math.floor(T.image.height*Z),wt=z!==null?z.x:0,Bt=z!==null?z.y:0;N.setTexture2D(T,0),G.copyTexSubImage2D(G.TEXTURE_2D,K,0,0,wt,Bt,W,ft),Wt.unbindTexture()},this.copyTextureToTexture=function(T,z,K=null,Z=null,W=0){T.isTexture!==!0&&(vr("WebGLRenderer: copyTextureToTexture function signature has changed."),Z=arguments[0]||null,T=arguments[1],z=arguments[2],W=arguments[3]||0,K=null);let ft,wt,Bt,kt,$t,jt,Ft,ae,we;const Te=T.isCompressedTexture?T.mipmaps[W]:T.image;K!==null?(ft=K.max.x-K.min.x,wt=K.max.y-K.min.y,Bt=K.isBox3?K.max.z-K.min.z:1,kt=K.min.x,$t=K.min.y,jt=K.isBox3?K.min.z:0):(ft=Te.width,wt=Te.height,Bt=Te.depth||1,kt=0,$t=0,jt=0),Z!==null?(Ft=Z.x,ae=Z.y,we=Z.z):(Ft=0,ae=0,we=0);const sn=Yt.convert(z.format),ue=Yt.convert(z.type);let Vt;z.isData3DTexture?(N.setTexture3D(z,0),Vt=G.TEXTURE_3D):z.isDataArrayTexture||z.isCompressedArrayTexture?(N.setTexture2DArray(z,0),Vt=G.TEXTURE_2D_ARRAY):(N.setTexture2D(z,0),Vt=G.TEXTURE_2D),G.pixelStorei(G.UNPACK_FLIP_Y_WEBGL,z.flipY),G.pixelStorei(G.UNPACK_PREMULTIPLY_ALPHA_WEBGL,z.premultiplyAlpha),G.pixelStorei(G.UNPACK_ALIGNMENT,z.unpackAlignment);const Oe=G.getParameter(G.UNPACK_ROW_LENGTH),me=G.getParameter(G.UNPACK_IMAGE_HEIGHT),An=G.getParameter(G.UNPACK_SKIP_PIXELS),ui=G.getParameter(G.UNPACK_SKIP_ROWS),mn=G.getParameter(G.UNPACK_SKIP_IMAGES);G.pixelStorei(G.UNPACK_ROW_LENGTH,Te.width),G.pixelStorei(G.UNPACK_IMAGE_HEIGHT,Te.height),G.pixelStorei(G.UNPACK_SKIP_PIXELS,kt),G.pixelStorei(G.UNPACK_SKIP_ROWS,$t),G.pixelStorei(G.UNPACK_SKIP_IMAGES,jt);const bs=T.isDataArrayTexture||T.isData3DTexture,Ce=z.isDataArrayTexture||z.isData3DTexture;if(T.isRenderTargetTexture||T.isDepthTexture){const Vn=Nt.get(T),qi=Nt.get(z),xn=Nt.get(Vn.__renderTarget),di=Nt.get(qi.__renderTarget);Wt.bindFramebuffer(G.READ_FRAMEBUFFER,xn.__webglFramebuffer),Wt.bindFramebuffer(G.DRAW_FRAMEBUFFER,di.__webglFramebuffer);for(let Zn=0;Zn<Bt;Zn++)bs&&G.framebufferTextureLayer(G.READ_FRAMEBUFFER,G.COLOR_ATTACHMENT0,Nt.get(T).__webglTexture,W,jt+Zn),T.isDepthTexture?(Ce&&G.framebufferTextureLayer(G.DRAW_FRAMEBUFFER,G.COLOR_ATTACHMENT0,Nt.get(z).__webglTexture,W,we+Zn),G.blitFramebuffer(kt,$t,ft,wt,Ft,ae,ft,wt,G.DEPTH_BUFFER_BIT,G.NEAREST)):Ce?G.copyTexSubImage3D(Vt,W,Ft,ae,we+Zn,kt,$t,ft,wt):G.copyTexSubImage2D(Vt,W,Ft,ae,we+Zn,kt,$t,ft,wt);Wt.bindFramebuffer(G.READ_FRAMEBUFFER,null),Wt.bindFramebuffer(G.DRAW_FRAMEBUFFER,null)}else Ce?T.isDataTexture||T.isData3DTexture?G.texSubImage3D(Vt,W,Ft,ae,we,ft,wt,Bt,sn,ue,Te.data):z.isCompressedArrayTexture?G.compressedTexSubImage3D(Vt,W,Ft,ae,we,ft,wt,Bt,sn,Te.data):G.texSubImage3D(Vt,W,Ft,ae,we,ft,wt,Bt,sn,ue,Te):T.isDataTexture?G.texSubImage2D(G.TEXTURE_2D,W,Ft,ae,ft,wt,sn,ue,Te.data):T.isCompressedTexture?G.compressedTexSubImage2D(G.TEXTURE_2D,W,Ft,ae,Te.width,Te.height,sn,Te.data):G.texSubImage2D(G.TEXTURE_2D,W,Ft,ae,ft,wt,sn,ue,Te);G.pixelStorei(G.UNPACK_ROW_LENGTH,Oe),G.pixelStorei(G.UNPACK_IMAGE_HEIGHT,me),G.pixelStorei(G.UNPACK_SKIP_PIXELS,An),G.pixelStorei(G.UNPACK_SKIP_ROWS,ui),G.pixelStorei(G.UNPACK_SKIP_IMAGES,mn),W===0&&z.generateMipmaps&&G.generateMipmap(Vt),Wt.unbindTexture()},this.copyTextureToTexture3D=function(T,z,K=null,Z=null,W=0){return T.isTexture!==!0&&(vr("WebGLRenderer: copyTextureToTexture3D function signature has changed."),K=arguments[0]||null,Z=arguments[1]||null,T=arguments[2],z=arguments[3],W=arguments[4]||0),vr('WebGLRenderer: copyTextureToTexture3D function has been deprecated. Use "copyTextureToTexture" instead.'),this.copyTextureToTexture(T,z,K,Z,W)},this.initRenderTarget=function(T){Nt.get(T).__webglFramebuffer===void 0&&N.setupRenderTarget(T)},this.initTexture=function(T){T.isCubeTexture?N.setTextureCube(T,0):T.isData3DTexture?N.setTexture3D(T,0):T.isDataArrayTexture||T.isCompressedArrayTexture?N.setTexture2DArray(T,0):N.setTexture2D(T,0),Wt.unbindTexture()},this.resetState=function(){L=0,A=0,D=null,Wt.reset(),pe.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Bi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;const e=this.getContext();e.drawingBufferColorspace=ge._getDrawingBufferColorSpace(t),e.unpackColorSpace=ge._getUnpackColorSpace()}}class Qh{constructor(t,e=1,n=1e3){this.isFog=!0,this.name="",this.color=new de(t),this.near=e,this.far=n}clone(){return new Qh(this.color,this.near,this.far)}toJSON(){return{type:"Fog",name:this.name,color:this.color.getHex(),near:this.near,far:this.far}}}class UD extends fn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ei,this.environmentIntensity=1,this.environmentRotation=new Ei,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),t.background!==null&&(this.background=t.background.clone()),t.environment!==null&&(this.environment=t.environment.clone()),t.fog!==null&&(this.fog=t.fog.clone()),this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),t.overrideMaterial!==null&&(this.overrideMaterial=t.overrideMaterial.clone()),this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){const e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(e.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(e.object.backgroundIntensity=this.backgroundIntensity),e.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(e.object.environmentIntensity=this.environmentIntensity),e.object.environmentRotation=this.environmentRotation.toArray(),e}}class kD extends En{constructor(t,e,n,s,o,a,r,l,c){super(t,e,n,s,o,a,r,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}}class qo extends _s{constructor(t=1,e=1,n=1,s=32,o=1,a=!1,r=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:s,heightSegments:o,openEnded:a,thetaStart:r,thetaLength:l};const c=this;s=Math.floor(s),o=Math.floor(o);const h=[],u=[],d=[],p=[];let _=0;const g=[],m=n/2;let f=0;M(),a===!1&&(t>0&&S(!0),e>0&&S(!1)),this.setIndex(h),this.setAttribute("position",new wi(u,3)),this.setAttribute("normal",new wi(d,3)),this.setAttribute("uv",new wi(p,2));function M(){const x=new et,F=new et;let L=0;const A=(e-t)/n;for(let D=0;D<=o;D++){const E=[],b=D/o,R=b*(e-t)+t;for(let H=0;H<=s;H++){const O=H/s,q=O*l+r,$=Math.sin(q),X=Math.cos(q);F.x=R*$,F.y=-b*n+m,F.z=R*X,u.push(F.x,F.y,F.z),x.set($,A,X).normalize(),d.push(x.x,x.y,x.z),p.push(O,1-b),E.push(_++)}g.push(E)}for(let D=0;D<s;D++)for(let E=0;E<o;E++){const b=g[E][D],R=g[E+1][D],H=g[E+1][D+1],O=g[E][D+1];(t>0||E!==0)&&(h.push(b,R,O),L+=3),(e>0||E!==o-1)&&(h.push(R,H,O),L+=3)}c.addGroup(f,L,0),f+=L}function S(x){const F=_,L=new ve,A=new et;let D=0;const E=x===!0?t:e,b=x===!0?1:-1;for(let H=1;H<=s;H++)u.push(0,m*b,0),d.push(0,b,0),p.push(.5,.5),_++;const R=_;for(let H=0;H<=s;H++){const q=H/s*l+r,$=Math.cos(q),X=Math.sin(q);A.x=E*X,A.y=m*b,A.z=E*$,u.push(A.x,A.y,A.z),d.push(0,b,0),L.x=$*.5+.5,L.y=X*.5*b+.5,p.push(L.x,L.y),_++}for(let H=0;H<s;H++){const O=F+H,q=R+H;x===!0?h.push(q,q+1,O):h.push(q+1,q,O),D+=3}c.addGroup(f,D,x===!0?1:2),f+=D}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new qo(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}}class $m extends Nr{static get type(){return"MeshStandardMaterial"}constructor(t){super(),this.isMeshStandardMaterial=!0,this.defines={STANDARD:""},this.color=new de(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new de(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Tm,this.normalScale=new ve(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ei,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.defines={STANDARD:""},this.color.copy(t.color),this.roughness=t.roughness,this.metalness=t.metalness,this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.roughnessMap=t.roughnessMap,this.metalnessMap=t.metalnessMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.envMapIntensity=t.envMapIntensity,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}}class tu extends fn{constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new de(t),this.intensity=e}dispose(){}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){const e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,this.groundColor!==void 0&&(e.object.groundColor=this.groundColor.getHex()),this.distance!==void 0&&(e.object.distance=this.distance),this.angle!==void 0&&(e.object.angle=this.angle),this.decay!==void 0&&(e.object.decay=this.decay),this.penumbra!==void 0&&(e.object.penumbra=this.penumbra),this.shadow!==void 0&&(e.object.shadow=this.shadow.toJSON()),this.target!==void 0&&(e.object.target=this.target.uuid),e}}class FD extends tu{constructor(t,e,n){super(t,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(fn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new de(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}}const rc=new He,Hf=new et,Vf=new et;class OD{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new ve(512,512),this.map=null,this.mapPass=null,this.matrix=new He,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Zh,this._frameExtents=new ve(1,1),this._viewportCount=1,this._viewports=[new We(0,0,1,1)]}getViewportCount(){return this._viewportCount}getFrustum(){return this._frustum}updateMatrices(t){const e=this.camera,n=this.matrix;Hf.setFromMatrixPosition(t.matrixWorld),e.position.copy(Hf),Vf.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(Vf),e.updateMatrixWorld(),rc.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),this._frustum.setFromProjectionMatrix(rc),n.set(.5,0,0,.5,0,.5,0,.5,0,0,.5,.5,0,0,0,1),n.multiply(rc)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.mapSize.copy(t.mapSize),this}clone(){return new this.constructor().copy(this)}toJSON(){const t={};return this.intensity!==1&&(t.intensity=this.intensity),this.bias!==0&&(t.bias=this.bias),this.normalBias!==0&&(t.normalBias=this.normalBias),this.radius!==1&&(t.radius=this.radius),(this.mapSize.x!==512||this.mapSize.y!==512)&&(t.mapSize=this.mapSize.toArray()),t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}}class BD extends OD{constructor(){super(new Bm(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}}class zD extends tu{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(fn.DEFAULT_UP),this.updateMatrix(),this.target=new fn,this.shadow=new BD}dispose(){this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}}class HD extends tu{constructor(t,e){super(t,e),this.isAmbientLight=!0,this.type="AmbientLight"}}const Gf=new He;class VD{constructor(t,e,n=0,s=1/0){this.ray=new Lm(t,e),this.near=n,this.far=s,this.camera=null,this.layers=new Yh,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,(e.near+e.far)/(e.near-e.far)).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):console.error("THREE.Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return Gf.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Gf),this}intersectObject(t,e=!0,n=[]){return fh(t,this,n,e),n.sort(Wf),n}intersectObjects(t,e=!0,n=[]){for(let s=0,o=t.length;s<o;s++)fh(t[s],this,n,e);return n.sort(Wf),n}}function Wf(i,t){return i.distance-t.distance}function fh(i,t,e,n){let s=!0;if(i.layers.test(t.layers)&&i.raycast(t,e)===!1&&(s=!1),s===!0&&n===!0){const o=i.children;for(let a=0,r=o.length;a<r;a++)fh(o[a],t,e,!0)}}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:Hh}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__=Hh);function GD(i,t){return-i*t*1.55}const WD=.3,$f=.8;function qm(i){return i.body_height+2*i.wheel_radius}function Xm(i,t){const e=i/qm(t)*WD*t.weight;return Math.max(-$f*t.weight,Math.min($f*t.weight,e))}const $D=120,To=.1,za=60,qf=1920;class qD{constructor(t,e,n){this.look=t,this.own=e;const s=(o,a=.7,r=0)=>{const l=new $m({color:o,roughness:a,metalness:r});return n&&(l.color.set(e),l.transparent=!0,l.opacity=.3),l};this.build(s,!n),this.root.add(this.body,...this.wheels),this.body.position.y=t.wheel_radius,this.root.traverse(o=>{o instanceof dn&&(o.castShadow=o.receiveShadow=!n)})}root=new yi;body=new yi;wheels=[new yi,new yi];x=0;z=0;last=null;build(t,e){const{wheel_radius:n,track:s,body_height:o,body_depth:a}=this.look,r=Math.max(s*.62,.02),l=n*.25,c=(u,d,p,_,g,m,f)=>{const M=new dn(new Ys(p,d,u),_);M.position.set(g,m,f),this.body.add(M)},h=t(this.own,.55);if(c(r,o*.94,a,h,0,l+o*.5,0),e&&c(s*.8,n*.5,a*.55,t("#3b424a",.6),0,0,0),e&&this.look.command_unit!=="V")for(const u of[.22,.5,.78])c(r*1.01,o*.03,a*1.02,t("#20262c",.6),0,l+o*u,0);else if(e){c(r*.72,o*.26,a*.04,t("#20262c",.25),a*.5,l+o*.72,0),c(r*.62,o*.18,a*.05,t("#b9d8c4",.3),a*.505,l+o*.73,0),c(r*.16,o*.08,a*.08,t("#f4f5f6",.5),a*.5,l+o*.42,0);for(const u of[-1,1])c(r*.14,o*.06,a*.07,t("#8b949d",.5),a*.5,l+o*.42,u*r*.22)}if(this.look.payload>0&&e){const u=Math.cbrt(this.look.payload/2500),d=this.look.payload_height-u/2-l;d>0&&c(.008,d,.008,t("#5c656e",.6),0,l+d/2,0),c(u,u,u,t("#8c5a2b",.8),0,this.look.payload_height,0)}this.wheels.forEach((u,d)=>this.tyre(u,d===0?-s/2:s/2,t,e))}tyre(t,e,n,s){const o=this.look.wheel_radius,a=Math.min(this.look.track*.16,o*.7),r=new dn(new qo(o,o,a,40),n("#23272c",.95)),l=new dn(new qo(o*.66,o*.66,a*1.04,32),n("#c9ced3",.45,.1));r.rotation.x=l.rotation.x=Math.PI/2,t.add(r),s&&t.add(l);for(let c=0;s&&c<3;c+=1){const h=new dn(new Ys(o*1.2,o*.13,a*1.1),n("#5c656e",.6));h.rotation.z=c*Math.PI/3,t.add(h)}t.position.set(0,o,e)}move(t,e){const{wheel_radius:n,track:s}=this.look,[o,,a,,r]=t;if(this.last!==null){const c=n*(a-this.last);this.x+=c*Math.cos(r),this.z-=c*Math.sin(r)}this.last=a,this.root.rotation.y=r,this.root.position.set(this.x+e*Math.sin(r),0,this.z+e*Math.cos(r)),this.body.rotation.z=-o;const l=s/(2*n)*r;this.wheels[0].rotation.z=-(a-l),this.wheels[1].rotation.z=-(a+l)}shift(t,e){this.x+=t,this.z+=e}start(t){t&&([this.x,this.z,this.last]=[t.x,t.z,t.last])}}function XD(i){const t=document.createElement("canvas");t.width=t.height=128;const e=t.getContext("2d");e.fillStyle=i?"#252b32":"#eeeeec",e.fillRect(0,0,128,128),e.strokeStyle=i?"#39424b":"#cfd1d2",e.lineWidth=2,e.strokeRect(0,0,128,128);const n=new kD(t);return n.wrapS=n.wrapT=Fa,n.repeat.set(za,za),n.anisotropy=8,n.colorSpace=Bn,n}class jD{constructor(t,e){this.canvas=t,this.push=e,this.element=t,this.renderer=new ID({canvas:t,antialias:!0}),this.renderer.shadowMap.enabled=!0,this.renderer.shadowMap.type=fm,this.floor=new dn(new Dr(za*To,za*To),new $m({roughness:.95})),this.floor.rotation.x=-Math.PI/2,this.floor.receiveShadow=!0,this.sun.castShadow=!0,this.sun.shadow.mapSize.set(1024,1024),this.sun.shadow.radius=6,this.sun.shadow.bias=-5e-4,this.shaft=new dn(new qo(1,1,1,16),this.ink),this.head=new dn(new qo(0,1,1,24),this.ink),this.arrow.add(this.shaft,this.head),this.arrow.visible=!1,this.ground.add(this.floor,this.arrow),this.scene.add(this.ground,this.sky,this.sun,this.sun.target,new HD("#ffffff",.35)),this.paint(),this.listen()}renderer;scene=new UD;camera=new Yn(32,1,.02,30);sun=new zD("#fffdf8",2.4);sky=new FD("#ffffff","#c4c6c8",1.1);floor;ground=new yi;figures=[];bodies=[];look=null;arrow=new yi;shaft;head;ink=new Kh;eye={azimuth:.5,height:.26,away:1};grip=null;turning=null;centre=new et;calm=matchMedia("(prefers-reduced-motion: reduce)");slow=0;detail=1;seen=-1;stale=!0;element;paint(){const t=document.documentElement.dataset.theme==="dark";this.ink.color.set(ps().push);const e=new de(t?"#1b2026":"#f4f3ef");this.scene.background=e,this.scene.fog=new Qh(e,1.2*this.size()+1.2,3*this.size()+2.2),this.floor.material.map=XD(t),this.floor.material.needsUpdate=!0,this.sun.intensity=t?1.7:1.9,this.stale=!0,this.sky.intensity=t?.7:1;const[n,s]=[this.look,this.bodies];n&&this.furnish(n,s)}furnish(t,e){const n=new Map(this.bodies.map((r,l)=>[r,this.figures[l]]));for(const r of this.figures)this.ground.remove(r.root);const s=this.look===null;this.look=t,this.bodies=e,this.seen=-1,this.stale=!0,this.figures=e.map((r,l)=>new qD(t,ls(r),l>0)),this.figures.forEach((r,l)=>r.start(n.get(e[l])));for(const r of this.figures)this.ground.add(r.root);const o=this.size(),a=o*2.2;Object.assign(this.sun.shadow.camera,{left:-a,right:a,top:a,bottom:-a,near:.01,far:o*12}),this.sun.shadow.camera.updateProjectionMatrix(),s&&this.paint()}size(){return this.look?Math.max(qm(this.look),this.look.payload>0?1.1*(this.look.payload_height+this.look.wheel_radius):0):.25}move(t){if(!this.look||t.x.length!==this.figures.length||t.n===this.seen)return;this.seen=t.n,this.stale=!0;const e=this.look.track;this.ground.rotation.z=t.f[2],this.figures.forEach((s,o)=>s.move(t.x[o],GD(o,e)));const n=this.figures[0];if(Math.hypot(n.x,n.z)>3){const s=r=>-Math.round(r/To)*To,[o,a]=[s(n.x),s(n.z)];for(const r of this.figures)r.shift(o,a);this.centre.add(new et(o,0,a))}this.show(t.f[0],t.f[1],t.x[0][0],t.x[0][4])}show(t,e,n,s){const o=this.look,a=this.figures[0].root.position;if(this.arrow.visible=Math.abs(t)>.005,!this.arrow.visible)return;const r=Math.min(.04+Math.abs(t)/o.weight*this.size()*1.2,this.size()*1.6),l=new et(Math.cos(s),0,-Math.sin(s)).multiplyScalar(Math.sign(t)),c=e*Math.sin(n),h=new et(a.x+c*Math.cos(s),o.wheel_radius+e*Math.cos(n),a.z-c*Math.sin(s)),u=o.body_depth/2+.004;this.arrow.position.copy(h).addScaledVector(l,-r-u),this.arrow.quaternion.setFromUnitVectors(new et(0,1,0),l);const[d,p]=[this.size()*.014,Math.min(r*.6,this.size()*.13)];this.shaft.scale.set(d,r-p,d),this.shaft.position.y=(r-p)/2,this.head.scale.set(3*d,p,3*d),this.head.position.y=r-p/2}draw(t){const{clientWidth:e,clientHeight:n}=this.canvas;if(!e||!n)return;this.pace(t);const s=Math.min(devicePixelRatio,2)*this.detail,o=this.renderer.getDrawingBufferSize(new ve);(Math.abs(o.x-e*s)>1||Math.abs(o.y-n*s)>1)&&(this.renderer.setPixelRatio(s),this.renderer.setSize(e,n,!1),this.camera.aspect=e/n,this.camera.updateProjectionMatrix(),this.stale=!0),this.stale&&(this.stale=this.follow(t),this.pull(),this.renderer.render(this.scene,this.camera))}pace(t){this.slow=t>45?this.slow+1:Math.max(0,this.slow-.5),this.slow>40&&this.detail>.8&&(this.detail*=.75,this.slow=0)}follow(t){const e=this.figures[0],n=this.size();e&&this.centre.lerp(new et(e.x,0,e.z),this.calm.matches?1:1-Math.exp(-t/$D));const s=this.camera.aspect<1?1.25:1,o=n*3.5*this.eye.away*s,{azimuth:a,height:r}=this.eye,l=o*Math.cos(r);this.ground.updateMatrixWorld();const c=this.ground.localToWorld(this.centre.clone()),h=c.clone().setY(c.y+n*.42);this.camera.position.set(h.x+l*Math.sin(a),h.y+o*Math.sin(r),h.z+l*Math.cos(a)),this.camera.lookAt(h),this.sun.position.set(c.x-n*2,c.y+n*5,c.z+n*2.4),this.sun.target.position.copy(c);const u=d=>Math.round(d/To)*To;return this.floor.position.set(u(this.centre.x),0,u(this.centre.z)),e?Math.hypot(e.x-this.centre.x,e.z-this.centre.z)>.001:!1}picture(t){const{clientWidth:e,clientHeight:n}=this.canvas;this.renderer.setPixelRatio(qf/e),this.renderer.setSize(e,n,!1),this.renderer.render(this.scene,this.camera);const{width:s,height:o}=this.canvas,[a,r]=[document.createElement("canvas"),Math.round(qf/28)];Object.assign(a,{width:s,height:o+r});const l=a.getContext("2d"),c=getComputedStyle(document.documentElement);return l.fillStyle=c.getPropertyValue("--card"),l.fillRect(0,0,s,o+r),l.drawImage(this.canvas,0,0),Object.assign(l,{fillStyle:c.getPropertyValue("--ink"),font:`${.45*r}px system-ui, sans-serif`,textBaseline:"middle"}),l.fillText(t,.4*r,o+r/2,s-.8*r),this.stale=!0,this.draw(0),new Promise(h=>a.toBlob(h))}turn(t,e){this.stale=!0,this.eye.azimuth+=t,this.eye.height=Math.min(1.2,Math.max(.03,this.eye.height+e))}zoom(t){this.stale=!0,this.eye.away=Math.min(3,Math.max(.45,this.eye.away*t))}grasp(){const t=this.look;if(!t)return{x:0,y:0};const e=this.figures[0].body.localToWorld(new et(0,t.body_height*.6,0)).project(this.camera);return{x:(e.x+1)/2*this.canvas.clientWidth,y:(1-e.y)/2*this.canvas.clientHeight}}pointer(t){const e=this.canvas.getBoundingClientRect();return new ve((t.clientX-e.left)/e.width*2-1,1-(t.clientY-e.top)/e.height*2)}ray(t){const e=new VD;return e.setFromCamera(t,this.camera),e}listen(){this.canvas.addEventListener("pointerdown",t=>this.down(t)),this.canvas.addEventListener("pointermove",t=>this.moved(t));for(const t of["pointerup","pointercancel","lostpointercapture"])this.canvas.addEventListener(t,()=>this.up());this.canvas.addEventListener("wheel",t=>{t.preventDefault(),this.zoom(Math.exp(t.deltaY/900))},{passive:!1})}down(t){if(!this.look||!this.figures.length)return;this.canvas.setPointerCapture(t.pointerId);const e=this.pointer(t),n=this.ray(e).intersectObject(this.figures[0].root,!0)[0];if(!n){this.turning={x:t.clientX,y:t.clientY};return}const s=this.figures[0].body.worldToLocal(n.point.clone());this.grip={at:s,mouse:e,height:Math.max(0,s.y)},this.pull(),this.canvas.classList.add("holding")}moved(t){this.turning&&(this.turn((this.turning.x-t.clientX)/160,(t.clientY-this.turning.y)/260),this.turning={x:t.clientX,y:t.clientY}),this.grip&&(this.grip.mouse=this.pointer(t),this.pull())}pull(){const[t,e]=[this.grip,this.look];if(!t||!e)return;const n=this.figures[0],s=n.body.localToWorld(t.at.clone()),o=this.camera.position.clone().sub(s).setY(0).normalize(),a=new rs().setFromNormalAndCoplanarPoint(o,s),r=this.ray(t.mouse).ray.intersectPlane(a,new et);if(!r)return;const l=n.root.rotation.y,c=r.sub(s).dot(new et(Math.cos(l),0,-Math.sin(l)).applyQuaternion(this.ground.quaternion));this.push({force:Xm(c,e),height:t.height})}up(){this.turning=null,this.grip&&(this.grip=null,this.canvas.classList.remove("holding"),this.push({force:0,height:0}))}}const YD="http://www.w3.org/2000/svg",Ao=170,KD=110,Xf=600;class ZD{constructor(t){this.push=t,this.element.addEventListener("pointerdown",e=>this.down(e)),this.element.addEventListener("pointermove",e=>this.moved(e));for(const e of["pointerup","pointercancel"])this.element.addEventListener(e,()=>this.up())}element=qn("svg",{viewBox:"-200 0 400 200",class:"room flat",role:"img",tabindex:"0"});sides=[];ground=qn("g");arrow=qn("path",{class:"arrow"});look=null;grip=null;paint(){}furnish(t,e){this.look=t,this.element.replaceChildren(this.ground),this.ground.replaceChildren(qn("line",{x1:-Xf,x2:Xf,y1:Ao,y2:Ao,class:"ground"})),this.sides=e.map((n,s)=>this.side(t,n,s>0)).reverse();for(const n of this.sides)this.ground.append(n.root);this.sides.reverse(),this.ground.append(this.arrow)}scale(t){return KD/(Math.max(t.body_height,t.payload>0?t.payload_height:0)+t.wheel_radius)}side(t,e,n){const s=this.scale(t),[o,a,r]=[t.wheel_radius*s,t.body_height*s,t.body_depth*s],l=n?{fill:"none",stroke:ls(e),"stroke-width":2,opacity:.7}:{},c=n?{}:{fill:ls(e)},h=qn("g");if(h.append(qn("rect",{x:-r/2,y:-a-o*.25,width:r,height:a,rx:3,class:n?"":"shell",...l,...c})),t.payload>0&&!n){const[p,_]=[Math.cbrt(t.payload/2500)*s,t.payload_height*s];h.append(qn("path",{d:`M0 0V${-_}`,class:"carrier"}),qn("rect",{x:-p/2,y:-_-p/2,width:p,height:p,class:"payload"}))}const u=qn("g");u.append(qn("circle",{r:o,class:n?"":"tyre",...l}),qn("path",{d:`M${-o*.6} 0H${o*.6}M0 ${-o*.6}V${o*.6}`,class:n?"":"spokes",...l}));const d=qn("g");return d.append(h,u),{root:d,body:h,wheel:u}}move(t){const e=this.look;if(!e||t.x.length!==this.sides.length)return;const n=this.scale(e),s=180/Math.PI;this.ground.setAttribute("transform",`rotate(${-t.f[2]*s} 0 ${Ao})`),this.sides.forEach((u,d)=>{const[p,,_]=t.x[d],g=(_-t.x[0][2])*e.wheel_radius*n;u.root.setAttribute("transform",`translate(${g} ${Ao-e.wheel_radius*n})`),u.body.setAttribute("transform",`rotate(${p*s})`),u.wheel.setAttribute("transform",`rotate(${_*s})`)});const[o,a]=t.f,r=o/e.weight*150,[l,c]=[a*Math.sin(t.x[0][0])*n,Ao-(e.wheel_radius+a*Math.cos(t.x[0][0]))*n],h=Math.sign(o)*7;this.arrow.setAttribute("d",Math.abs(o)>.005?`M${l-r-h} ${c}H${l}m${-h} -5L${l} ${c}l${-h} 5`:"")}draw(){}picture(){return Promise.resolve(new Blob([new XMLSerializer().serializeToString(this.element)],{type:"image/svg+xml"}))}turn(){}zoom(){}grasp(){const t=(this.sides[0]?.body.firstElementChild??this.element).getBoundingClientRect(),e=this.element.getBoundingClientRect();return{x:t.x-e.x+t.width/2,y:t.y-e.y+t.height*.4}}down(t){const e=this.sides[0];if(!this.look||!e?.root.contains(t.target))return;this.element.setPointerCapture(t.pointerId);const n=this.element.getBoundingClientRect().height/200,s=this.element.getBoundingClientRect().y+(Ao-this.look.wheel_radius*this.scale(this.look))*n;this.grip={x:t.clientX,height:Math.max(0,(s-t.clientY)/n/this.scale(this.look))},this.push({force:0,height:this.grip.height})}moved(t){if(!this.grip||!this.look)return;const e=this.scale(this.look)*this.element.getBoundingClientRect().height/200;this.push({force:Xm((t.clientX-this.grip.x)/e,this.look),height:this.grip.height})}up(){this.grip&&(this.grip=null,this.push({force:0,height:0}))}}function qn(i,t={}){const e=document.createElementNS(YD,i);for(const[n,s]of Object.entries(t))s!==""&&e.setAttribute(n,String(s));return e}const JD=["loop","portrait","voltages","estimate","equations"],pa=8,QD=["ψ̇","ψ̈","θ̇","θ̈","φ̇","φ̈"];class tI{root=k("div",{className:"see"});view="loop";stage=k("div",{className:"stage"});strips=[];build(){const t=JD.map(n=>[n,U(n)]),e=fs(U("viewLabel"),t,this.view,n=>{this.view=n,this.show()},"view");Xt(this.root,e,this.stage),this.show()}show(){this.strips=[],this.view==="loop"?Xt(this.stage,...this.loop()):this.view==="equations"?Xt(this.stage,...sI()):this.view==="voltages"?this.voltages():this.view==="estimate"?this.estimate():this.portrait()}draw(){if(this.view==="portrait"&&this.portrait(),!this.strips.length)return;const t=C.traces,e=t.t.at(-1)??0;let n=t.t.length;for(;n>0&&t.t[n-1]>=e-pa;)n-=1;const s=t.t.slice(n),o=a=>a.slice(n);if(this.view==="estimate")this.strips[0].show(s,[t.x[0]?.[0]??[],t.estimate].map(a=>xa(o(a))),e-pa,e);else{const a=[1,2].map((r,l)=>o(t.saturated).map((c,h)=>c&r?t.volts[l][n+h]:NaN));this.strips.forEach((r,l)=>r.show(s,[o(t.volts[l]),a[l]],e-pa,e))}}voltages(){const{text:t,push:e}=ps(),n=C.changed?.look.command_unit??"V";this.strips=[U("leftMotor"),U("rightMotor")].map(o=>new Mc(o,n,[{label:o,colour:t,dash:[]},{label:U("saturated"),colour:e,dash:[],width:5}],150,1));const s=k("p",{className:"note"},U(n==="V"?"voltagesNote":"torquesNote"));Xt(this.stage,s,...this.strips.map(o=>o.root))}estimate(){if(!C.snapshot?.e.length){Xt(this.stage,k("p",{className:"note"},U("noEstimate")));return}const{push:t}=ps(),e=[{label:U("truth"),colour:ls(C.changed?.bodies[0]??"twin"),dash:[]},{label:U("opinion"),colour:t,dash:[4,3]}];this.strips=[new Mc(`ψ: ${U("truth")} ──  ${U("opinion")} ╌╌`,"°",e,190,1)],Xt(this.stage,k("p",{className:"note"},U("estimateNote")),this.strips[0].root)}portrait(){const{t,x:e}=C.traces,n=(t.at(-1)??0)-pa;let s=t.length;for(;s>0&&t[s-1]>=n;)s-=1;const o=(a,r)=>{const l=e.map((d,p)=>{const _=C.changed?.bodies[p]??"";return{x:xa(d[a].slice(s)),y:xa(d[a+1].slice(s)),colour:ls(_),dash:kh(_,C.changed?.bodies??[])}}),c=(d,p)=>{const _=l.flatMap(f=>f[d]),[g,m]=[_.reduce((f,M)=>Math.min(f,M),1/0),_.reduce((f,M)=>Math.max(f,M),-1/0)];return Jp(g,m,p)},h=l.map(d=>({x:d.x.at(-1)??0,y:d.y.at(-1)??0,colour:d.colour})),u=Qe(qs[a]);return Ha(u,Da({title:`${U("portrait")}: ${u}`,xLabel:`${Vs[a]} [°]`,yLabel:`${Vs[a+1]} [°/s]`,lines:l,points:h,x:c("x",r[0]),y:c("y",r[1]),square:!0}))};Xt(this.stage,o(0,[2,20]),o(2,[30,60]),o(4,[3,12]))}loop(){const t=C.analysed;if(C.setup.controller==="off")return[k("p",{className:"note"},U("noLoop"))];if(!t)return[k("p",{className:"note"},U("designing"))];const e=ls("twin"),n=rm(t);return t.L.length===3&&n.push(...eI(t.L,e)),t.poles.length&&n.push(nI(t.poles,e)),n}}function eI([i,t,e],n){const s=i.map((u,d)=>20*Math.log10(Math.hypot(t[d],e[d]))),o=iI(i.map((u,d)=>Math.atan2(e[d],t[d])*180/Math.PI)),a=[i[0],i.at(-1)],r=(u,d)=>[Math.min(...u)-d,Math.max(...u)+d],l=(u,d,p,_)=>[Da({title:U("bode"),xLabel:"ω [rad/s]",yLabel:u,lines:[{x:i,y:d,colour:n}],x:a,y:r(d,p),logX:!0,marks:[{y:_}],read:!0}),k("output",{})],c=e.map(u=>-u),h=Da({title:U("nyquist"),xLabel:"Re L",yLabel:"Im L",square:!0,x:[-3.2,1.6],y:[-2,2],circle:!0,lines:[{x:t,y:e,colour:n},{x:t,y:c,colour:n,dash:[4,3]}],points:[{x:-1,y:0,colour:ps().push,cross:!0}]});return[Ha(U("bode"),...l("|L| [dB]",s,3,0),...l("∠L [°]",o,8,-180)),Ha(U("nyquist"),h)]}function nI(i,t){const e=i.map(([o,a])=>({x:o,y:a,colour:Math.hypot(o,a)>=1?ps().push:t,cross:!0})),n=Math.max(1.15,...i.map(([o,a])=>Math.max(Math.abs(o),Math.abs(a))*1.1)),s=n*1.2;return Ha(U("poles"),Da({title:U("poles"),xLabel:"Re z",yLabel:"Im z",points:e,x:[-s,s],y:[-n,n],square:!0,circle:!0}))}function Ha(i,...t){return k("figure",{className:"titled","aria-label":i},k("figcaption",{},i),...t)}function iI(i){let t=0;return i.map((e,n)=>(n&&(t+=Math.round((i[n-1]-e)/360)*360),e+t)).map((e,n,s)=>e-Math.round((s[0]+180)/360)*360)}function sI(){const i=C.equations;if(!i)return[];const[t,,e,n]=i.inertias.map(x=>_e(x,4)),[s,o,a,r]=[i.alpha,i.beta,i.weight,i.lever].map(x=>_e(x,4)),[l,c]=[_e(i.swing,4),_e(i.half_track,4)],h=`(${r} cos ψ − ${_e(i.lever-i.inertias[1],3)})`,u=C.changed?.look.command_unit==="rad/s",[d,p,_]=u?["","τ_l","τ_r"]:[`${s} `,"v_l","v_r"],[g,m]=[`${d}(${p} + ${_})`,`2·${o} (θ̇ − ψ̇)`],f=[`${t} θ̈ + ${h} ψ̈ = ${g} − ${m} + ${r} (ψ̇² + φ̇²) sin ψ`,`${h} θ̈ + ${e} ψ̈ = −${g} + ${m} + (${a} + ${l} φ̇² cos ψ) sin ψ`,`(${n} + ${l} sin² ψ) φ̈ = ${c}·${d}(${_} − ${p}) − 2·${c}²·${o} φ̇ − (2·${l} ψ̇ cos ψ + ${r} θ̇) φ̇ sin ψ`,`${u?"τ: (θ̇ − ψ̇)˙ = (v − θ̇ + ψ̇)/T":`α = ${s}   β = ${o}`}   M g L = ${a} N m   M L R = ${r} kg m²   W/2R = ${c}`],M=(x,F)=>qp([x,...F[0].map((L,A)=>x==="A"?Vs[A]:["v_l","v_r"][A])],F.map((L,A)=>[QD[A],...L.map(D=>_e(D,4))]),"matrix"),S=i.poles.map(([x,F])=>_e(x,4)+(F?` ± ${_e(Math.abs(F),3)}j`:"")).join(";  ");return[k("div",{className:"equations"},...f.map(x=>k("div",{},x))),k("p",{className:"note"},U("equationsNote")),k("p",{},`${U("openPoles")}: ${S} 1/s`),k("h4",{},U("linearised")),M("A",i.A),M("B",i.B)]}const jf=.25,Yf=1.5,oI=.12,rI=.15;class aI{held=new Set;last="";asked=0;padded=!1;constructor(){window.addEventListener("keydown",t=>this.down(t)),window.addEventListener("keyup",t=>this.up(t)),window.addEventListener("blur",()=>this.release())}down(t){t.repeat||bc(t,"input, select, textarea, [role=tab], .table, dialog, dialog *")||/^(Arrow(Up|Down|Left|Right)|f|b)$/.test(t.key)&&(t.preventDefault(),this.held.add(t.key),this.push(),this.steer(...this.keys()))}up(t){this.held.delete(t.key)&&(this.push(),this.steer(...this.keys()))}release(){this.held.size&&(this.held.clear(),this.push(),this.steer(0,0))}keys(){const t=e=>this.held.has(e)?1:0;return[jf*(t("ArrowUp")-t("ArrowDown")),Yf*(t("ArrowLeft")-t("ArrowRight"))]}pushing=!1;push(){const t=(this.held.has("b")?1:0)-(this.held.has("f")?1:0);if(!t&&!this.pushing)return;this.pushing=t!==0;const e=C.changed?.look;C.push({kind:"Drag",force:t*oI*(e?.weight??6),height:e?.com_height??.07})}steer(t,e){const n=`${t.toFixed(2)} ${e.toFixed(2)}`;n!==this.last&&(this.last=n,C.send({kind:"Steer",speed:t,rate:e}))}tick(t){if(t-this.asked<60)return;this.asked=t;const e=navigator.getGamepads?.().find(s=>s?.connected);if(this.held.size||!e&&!this.padded)return;this.padded=!!e;const n=s=>{const o=e?.axes[s]??0;return Math.abs(o)<rI?0:-o};this.steer(jf*n(1),Yf*n(0))}}const lI=[.2,3/8,5/9,2/3],cI=(i,t)=>e=>{const n=4*i+e-4,s="*-04-39?2$%%$%%'$%''%'''%')(%'))%(++'(++'(+.'+-.',/3',33)-/5)-43).36)058*18<+37<+4:<,4:E,5<A-7>C/8@F/:EH/<EK0=FM1?IP2@KS3BNV4DPY5FS\\6HV_6IXb7K[e8N^i9Pam;Rdp<Tgt".charCodeAt(n)-35,o=n>8?s:1,a=t/o|0,r=t%o,l=o-r,c=n>8?a*lI[e]+(i>5)&-2:s,h=a-c;return{t:l*h+r*h+r,o:[[l,h],[r,h+1]],i:c}},Kf={M:1},Zs=i=>new Uint8Array(i),br=i=>{const t=new Error(`lean-qr error ${i}`);throw t.code=i,t},ma=i=>"0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ $%*+-./:".indexOf(i),ph=i=>i.charCodeAt(0),jm=(...i)=>(t,e)=>i.forEach(n=>n(t,e)),Ym=i=>t=>{t.eci!==i&&(t.push(7,4),i<128?t.push(i,8):i<16384?t.push(32768|i,16):t.push(12582912|i,24),t.eci=i)},eu=i=>(t,e)=>{t.push(4,4),t.push(i.length,8+8*(e>9)),i.forEach(n=>t.push(n,8))},tr=(i,t,e,n,s=(a,r)=>e(a.length,r),o=n?a=>jm(Ym(n),i(a)):i)=>(o.test=t,o.l=e,o.est=s,o.eci=n&&[n],o),Km=tr(i=>(t,e)=>{t.push(1,4),t.push(i.length,10+2*(e>26)+2*(e>9));let n=0;for(;n<i.length-2;n+=3)t.push(+i.slice(n,n+3),10);n<i.length-1?t.push(+i.slice(n),7):n<i.length&&t.push(+i[n],4)},i=>/[0-9]/.test(i),(i,t)=>14+2*(t>26)+2*(t>9)+10*i/3),Zm=tr(i=>(t,e)=>{t.push(2,4),t.push(i.length,9+2*(e>26)+2*(e>9));let n=0;for(;n<i.length-1;n+=2)t.push(45*ma(i[n])+ma(i[n+1]),11);n<i.length&&t.push(ma(i[n]),6)},i=>ma(i)>=0,(i,t)=>13+2*(t>26)+2*(t>9)+5.5*i),Xo=tr(i=>eu([...i].map(ph)),i=>ph(i)<128,(i,t)=>12+8*(t>9)+8*i);Xo._=!0,Xo.u=!0;const nu=tr(Xo,i=>ph(i)<256,Xo.l,3);nu._=!0;const Zf=new TextEncoder,iu=tr(i=>eu(Zf.encode(i)),()=>1,0,26,(i,t)=>12+8*(t>9)+8*Zf.encode(i).length);iu._=!0;let mh=()=>{const i=new Map,t=new TextDecoder("sjis"),e=Zs(2);for(let n=0;n<7973;++n)e[0]=n/192+129+64*(n>5951),e[1]=n%192+64,i.set(t.decode(e),n);return i.delete("�"),mh=()=>i,i};const su=tr(i=>(t,e)=>{t.push(8,4),t.push(i.length,8+2*(e>26)+2*(e>9));for(const n of i)t.push(mh().get(n),13)},i=>mh().has(i),(i,t)=>12+2*(t>26)+2*(t>9)+13*i);su._=!0;const Jm=[Km,Zm,Xo,nu,su,iu],hI={auto:(i,{modes:t=Jm}={})=>(e,n)=>{const s=t.map((h,u)=>{const d=new Map,p=(_,g)=>(d.has(_)||d.set(_,g(_,n)),d.get(_));return{m:h,h:1<<u,C:h.est("",n),S:h.l?(_,g)=>p(g-_,h.l):(_,g)=>p(i.slice(_,g),h.est)}});let o=[{v:0}],a=0,r=0,l=-1;for(const h of[...i,""]){let u=0;if(h)for(const d of s)d.m.test(h)&&(u|=d.h);if(!h||u!==l){if(l!==-1){const d=new Set(o.map(_=>_.D)),p=[];for(const{m:_,C:g,S:m,h:f}of s)if(l&f){const M=m(a,r);for(const S of _.eci??d)if(!_.u||!S){let x;for(const F of o)if(F.D===S||_.eci){const L=F.m===_&&F.D===S,A=L?F.V:F,D=_._&&L?F.v+M-g:A.v+12*(A.D!==S)+(L?m(L?F.$:a,r):M);(!x||D<x.v)&&(x={$:L?F.$:a,V:A,m:_,D:S,A:r,v:D})}x&&p.push(x)}}o=p}l=u,a=r}r+=h.length}o.length||br(5);const c=[];for(let h=o.reduce((u,d)=>d.v<u.v?d:u);h.m;h=h.V)c.push(h.m(i.slice(h.$,h.A)));c.reverse().forEach(h=>h(e,n))},multi:jm,eci:Ym,bytes:eu,numeric:Km,alphaNumeric:Zm,ascii:Xo,iso8859_1:nu,shift_jis:su,utf8:iu},uI=()=>({F:Zs(2956),I:0,push(i,t){for(let e=t,n=8-(7&this.I);e>0;e-=n,n=8)this.F[this.I>>3]|=i<<n>>e,this.I+=e<n?e:n}}),ac=(i,t=i*i,e=Zs(t))=>({size:i,K:e,get:(n,s)=>n>=0&&n<i&&!!(1&e[s*i+n]),toString({on:n="##",off:s="  ",lf:o=`
`,pad:a=4,padX:r=a,padY:l=a}={}){let c="";for(let h=-l;h<i+l;++h){for(let u=-r;u<i+r;++u)c+=this.get(u,h)?n:s;c+=o}return c},toImageData(n,{on:s=[0,0,0],off:o=[0,0,0,0],pad:a=4,padX:r=a,padY:l=a}={}){const c=i+2*r,h=i+2*l,u=n.createImageData(c,h),d=new Uint32Array(u.data.buffer);u.data.set([...s,255]);const p=d[0];u.data.set([...o,255]);const _=d[0];for(let g=0;g<h;++g)for(let m=0;m<c;++m)d[g*c+m]=this.get(m-r,g-l)?p:_;return u},toCanvas(n,s){const o=n.getContext("2d"),a=this.toImageData(o,s);n.width=a.width,n.height=a.height,o.putImageData(a,0,0)},toDataURL({type:n="image/png",scale:s=1,...o}={}){const a=document.createElement("canvas"),r=a.getContext("2d"),l=this.toImageData(r,o);return a.width=l.width*s,a.height=l.height*s,r.putImageData(l,0,0),r.imageSmoothingEnabled=!1,r.globalCompositeOperation="copy",r.drawImage(a,0,0,l.width,l.height,0,0,a.width,a.height),a.toDataURL(n,1)}}),ga=[(i,t)=>1&(i^t),(i,t)=>1&t,i=>i%3,(i,t)=>(i+t)%3,(i,t)=>1&(i/3^t>>1),(i,t)=>(i&t&1)+i*t%3,(i,t)=>(i&t)+i*t%3&1,(i,t)=>(i^t)+i*t%3&1],Va=Zs(511);for(let i=0,t=1;i<255;t=2*t^285*(t>127))Va[Va[t+255]=i++]=t;const Qm=i=>Va[i%255],tg=i=>Va[i+255],dI=(i,t)=>{const e=Zs(i.length+t.length-1);for(let n=0;n<i.length;++n)for(let s=0;s<t.length;++s)e[n+s]^=Qm(i[n]+t[s]);return e.map(tg)},fI=(i,t)=>{const e=Zs(i.length+t.length-1);e.set(i,0);for(let n=0;n<i.length;++n)if(e[n]){const s=tg(e[n]);for(let o=0;o<t.length;++o)e[n+o]^=Qm(t[o]+s)}return e.slice(i.length)},gh=[[0],[0,0]];for(let i=1;i<30;++i)gh.push(dI(gh[i],[0,i]));const pI=(i,t)=>{const e=[[],[]];let n=0,s=0;for(const[a,r]of t.o)for(let l=0;l<a;++l,n+=r){const c=i.slice(n,n+r);e[0].push(c),e[1].push(fI(c,gh[t.i])),s+=r+t.i}const o=Zs(s);s=0;for(const a of e)for(let r=0,l=-1;l<s;++r){l=s;for(const c of a)r<c.length&&(o[s++]=c[r])}return o},eg=(i,t,e)=>{let n=i<<=e;for(let s=134217728;s>>=1;)n&s&&(n^=t*(s>>e));return n|i},mI=({size:i,K:t},e)=>{const n=(a,r,l,c)=>{for(;l-- >0;a+=i)t.fill(c,a,a+r)},s=(a,r,l)=>{for(let c=0;c++<3;l-=2)n(r*i+a-(l>>1)*(i+1),l,l,2|c)},o=2*((i-13)/(1+(e/7|0))/2+.75|0);if(e>1)for(let a=i-7;a>8;a-=o){for(let r=a;r>8;r-=o)s(a,r,5);a<i-7&&s(a,6,5)}if(e>6)for(let a=eg(e,7973,12),r=1;r<7;++r)for(let l=12;l-- >9;a>>=1)t[r*i-l]=2|1&a;n(7,2,9,2),n(i-8,8,9,2);for(let a=0;a<i;++a)t[6*i+a]=3^1&a;s(3,3,7),s(i-4,3,7);for(let a=0;a<i;++a)for(let r=a;r<i;++r)t[r*i+a]=t[a*i+r];t[(i-8)*i+8]=3},gI=({size:i,K:t})=>{const e=[];for(let n=i-2,s=i,o=-1;n>=0;n-=2){for(n===5&&(n=4);s+=o,s!==-1&&s!==i;){const a=s*i+n;t[a+1]||e.push(a+1),t[a]||e.push(a)}o*=-1}return e},_I=({K:i},t,e)=>t.forEach((n,s)=>i[n]=e[s>>3]>>(7&~s)&1),vI=({size:i,K:t},e,n,s)=>{for(let a=0;a<i;++a)for(let r=0;r<i;++r){const l=a*i+r;t[l]^=!(e(r,a)||2&t[l])}let o=21522^eg((1^s)<<3|n,1335,10);for(let a=0;a++<8;o>>=1)t[(a-(a<7))*i+8]=1&o,t[9*i-a]=1&o;for(let a=8;--a,o;o>>=1)t[8*i+a-(a<7)]=1&o,t[(i-a)*i+8]=1&o},xI=({size:i,K:t},e=0,n=0)=>{for(let s=0;s<i;++s){for(let o=0;o<2;++o)for(let a,r=0,l=0,c=2;r<i;++r){const h=1&t[o?s*i+r:r*i+s];n+=h,l=(l>>1|2098176)&(3047517^h-1),2049&l&&(e+=40),h^c&&(a=0),c=h,e+=++a===5?3:a>5}if(s)for(let o=i+s,a=5*t[s-1]^t[s];o<i*i;o+=i){const r=5*t[o-1]^t[o];e+=3*!(1&(a|r)|4&(a^r)),a=r}}return e+10*(10*Math.abs(n/(i*i)-1)|0)},Jf=[],_h=(i=br(1),{minCorrectionLevel:t=0,maxCorrectionLevel:e=3,minVersion:n=1,maxVersion:s=40,mask:o,trailer:a=60433,...r}={})=>{e<t&&br(3),s<n&&br(2),typeof i=="string"&&(i=hI.auto(i,r));for(let l=n,c=0;l<=s;++l){let h=Jf[l];h||(Jf[l]=h=ac(4*l+17),mI(h,l),h.p=gI(h));const u=cI(l,h.p.length>>3);if(8*u(t).t<c)continue;const d=uI();i(d,l),c=d.I;for(let p=e;p>=t;--p){const _=u(p);if(8*_.t<c)continue;for(d.I=c+11&-8;d.I<8*_.t;)d.push(a,16);const g=ac(h.size,h.K);return _I(g,h.p,pI(d.F,_)),(ga[o]?[ga[o]]:ga).map((m,f)=>{const M=ac(g.size,g.K);return vI(M,m,o??f,p),M.s=ga[o]?0:xI(M),M}).reduce((m,f)=>f.s<m.s?f:m)}}br(4)};_h.with=(...i)=>(t,e)=>_h(t,{modes:[...Jm,...i],...e});const lc="http://www.w3.org/2000/svg",fr=4;function bI(i,t){const e=_h(i,{minCorrectionLevel:Kf.M,maxCorrectionLevel:Kf.M}),n=document.createElementNS(lc,"svg"),s=e.size+2*fr;n.setAttribute("viewBox",`${-fr} ${-fr} ${s} ${s}`),n.setAttribute("class","qr"),n.setAttribute("role","img"),n.setAttribute("aria-label",t);const o=document.createElementNS(lc,"rect");for(const[l,c]of Object.entries({x:-fr,y:-fr,width:s,height:s,fill:"#ffffff"}))o.setAttribute(l,String(c));const a=document.createElementNS(lc,"path");let r="";for(let l=0;l<e.size;l+=1)for(let c=0;c<e.size;c+=1)e.get(c,l)&&(r+=`M${c} ${l}h1v1h-1z`);return a.setAttribute("d",r),a.setAttribute("fill","#000000"),a.setAttribute("shape-rendering","crispEdges"),n.append(o,a),n}const Qf="http://www.w3.org/2000/svg";class yI{root=k("div",{className:"panel-body"});wall=k("div",{className:"wall"});scores=k("div",{className:"table"});build(){const t=k("div",{className:"column wide"});C.role==="teacher"&&t.append(k("div",{className:"row"},te(U("broadcast"),()=>C.send({kind:"Broadcast",setup:C.setup}),{className:"main","data-key":"broadcast"}),te(U("results"),()=>wI(SI()),{"data-key":"results"})),MI(),this.wall),t.append(this.scores),Xt(this.root,t),this.update()}update(){const t=C.board?.students??[];Xt(this.wall,...t.map(EI));const e=k("thead",{},k("tr",{},...["",U("name"),U("bestPush"),U("effort"),U("family")].map(s=>k("th",{scope:"col"},s)))),n=t.map((s,o)=>k("tr",{className:s.here?"":"away"},k("td",{},String(o+1)),k("td",{},s.name),k("td",{},si(s.best,3)),k("td",{},si(s.effort,0)),k("td",{},Qe(s.controller).split(":")[0])));Xt(this.scores,k("table",{className:"board","aria-label":U("board")},e,k("tbody",{},...n)))}}function MI(){const i=new URL(`#token=${C.invite}`,location.href.split("#")[0]).href;return k("figure",{className:"invite"},bI(i,U("invite")),k("figcaption",{},k("b",{},U("invite")),k("code",{},i)))}function SI(){const i=e=>`"${e.replace(/^[=+\-@\t]/,"'$&").replaceAll('"','""')}"`;return["place,name,best_push_Ns,effort_u2s,controller,here",...(C.board?.students??[]).map((e,n)=>[n+1,i(e.name),e.best.toFixed(4),e.effort.toFixed(1),i(e.controller),e.here].join(",")),""].join(`\r
`)}function wI(i){const t=URL.createObjectURL(new Blob(["\uFEFF",i],{type:"text/csv"}));k("a",{href:t,download:"results.csv"}).click(),window.setTimeout(()=>URL.revokeObjectURL(t),1e4)}function EI(i){const t=document.createElementNS(Qf,"svg");t.setAttribute("viewBox","-30 -48 60 60"),t.setAttribute("aria-hidden","true");const e=(s,o)=>{const a=document.createElementNS(Qf,s);for(const[r,l]of Object.entries(o))a.setAttribute(r,l);t.append(a)},n=(i.pitch*180/Math.PI).toFixed(1);return e("rect",{x:"-6",y:"-40",width:"12",height:"38",rx:"3",class:"stick",transform:`rotate(${n})`}),e("circle",{r:"8",cx:"0",cy:"0",class:"wheel"}),e("line",{x1:"-30",x2:"30",y1:"8.5",y2:"8.5",class:"ground"}),k("figure",{className:`tile${i.fallen?" down":""}${i.here?"":" away"}`},t,k("figcaption",{},i.name))}const Ps=["twin","nonlinear","linear"],TI=[{setup:{},lean:0,acts:[.05,.3,"size"]},{setup:{controller:"off",bodies:Ps},lean:tl,speed:.1,ceiling:.3},{setup:{controller:"off",kit:"ideal",bodies:["nonlinear","linear"]},lean:.03,speed:.1},{setup:{controller:"lqr",bodies:Ps},lean:.1,acts:["tilt"]},{setup:{controller:"lqg",bodies:Ps},lean:0,strike:"front"},{setup:{controller:"lqg",bodies:Ps},lean:0,strike:"back",acts:["curves"]},{setup:{controller:"lqg",bodies:Ps},lean:0,strike:"front",live:!0,acts:["identify"]},{setup:{controller:"lqr",bodies:Ps,payload:.2,payload_height:.3},lean:0,acts:[.05,.3]},{setup:{controller:"robust",bodies:Ps,payload:.2,payload_height:.3},lean:0,live:!0,acts:[.05,.3,"tilt"]}],pr=TI.map((i,t)=>({scene:i,i:t})).filter(({scene:i})=>!(Ze&&i.live));class AI{constructor(t){this.tools=t}root=k("div",{className:"panel-body tour"});at=0;before=null;awaits=!1;build(){const{i:t,scene:e}=pr[this.at],{here:n,...s}=Ja().tour[t],o=t===0&&!C.setup.bodies.includes("twin"),a={...s,...(Ze||o)&&n},r=(c,h,...u)=>k("div",{className:"hint-part"},k("h4",{},c),k("p",{},h),...u),l=(e.acts??[]).map(c=>this.control(c));Xt(this.root,k("div",{className:"column wide"},k("p",{className:"note"},U("tourStep",{n:this.at+1,all:pr.length})),k("h3",{},a.title),k("div",{className:"hints"},r(U("tourDo"),a.do,k("div",{className:"acts"},...l)),r(U("tourWatch"),a.watch),r(U("tourAsk"),a.ask)),k("div",{className:"row"},te(U("previous"),()=>this.move(-1,"previous"),{disabled:this.at===0,"data-key":"tour-previous"}),this.at||this.before?te(U("tourSet"),()=>this.set(),{className:this.at?"main":"","data-key":"tour-set"}):null,te(U("next"),()=>this.move(1,"next"),{className:this.at?"":"main",disabled:this.at===pr.length-1,"data-key":"tour-next"})),this.before?te(U("tourBack"),()=>this.back(),{className:"quiet","data-key":"tour-back"}):null))}control(t){const{knock:e,sizer:n,tilt:s,curves:o,identify:a}=this.tools,r={"data-key":`act-${t}`};if(typeof t=="number")return te(Dh(U("mark_impulse",{size:t.toFixed(2)})),()=>e(t),r);switch(t){case"size":return n();case"tilt":return te(U("tilt"),s,{...r,title:U("tiltTip")});case"curves":return te(U("moreCurves"),o,r);case"identify":return te(U("tabIdentify"),a,r)}}move(t,e="set"){this.at=Math.min(Math.max(this.at+t,0),pr.length-1),this.build();const n=o=>this.root.querySelector(`[data-key=tour-${o}]:enabled`);(n(e)??n("set")??n("next"))?.focus({preventScroll:Gs.matches});const s=this.root.parentElement;s&&(s.scrollTop=0),Gs.matches&&this.upward(s?.parentElement?.querySelector(".tabs"))}upward(t){if(!t)return;const e=Math.max(...[t,document.documentElement].map((n,s)=>parseFloat(getComputedStyle(n)[s?"scrollPaddingTop":"scrollMarginTop"])||0));this.root.getBoundingClientRect().top<e+t.clientHeight&&(e?t:t.parentElement)?.scrollIntoView()}back(){this.before&&C.change(this.before),C.last.name(null),this.before=null,this.tools.run(1),C.send({kind:"StandUp",pitch:0}),this.build()}designed(){const t=this.awaits&&C.setup.controller==="robust";return this.awaits=!1,t&&C.send({kind:"StandUp",pitch:0}),t}set(){const{setup:t,lean:e,speed:n,strike:s,ceiling:o}=pr[this.at].scene;this.before||(this.before=C.setup,this.build(),this.root.querySelector("[data-key=tour-set]")?.focus()),C.anew(()=>{this.tools.run(n??1),C.change({...Vi,...t}),C.ceiling=o??null,C.send({kind:"StandUp",pitch:e})}),this.awaits=t.controller==="robust",s&&window.setTimeout(()=>C.send({kind:"Strike",what:s,size:s==="front"?.1:-.12}),1e3)}}const tp=["Tour","Controller","Robot","Kit","See","Identify","Keep","Class","Python"],ep=["Tour","Controller","Robot","See","Keep","Python"],RI=.19,cc=[.01,.5],CI=10,PI=1e-6,LI={good:"info",info:"info",unknown:"info",warn:"warn",bad:"warn"},NI=1500,DI=400;function II(){const i=document.createElement("canvas").getContext("webgl2"),t=i?.getExtension("WEBGL_debug_renderer_info"),e=i?.getParameter(t?.UNMASKED_RENDERER_WEBGL??i.RENDERER);return i?.getExtension("WEBGL_lose_context")?.loseContext(),{able:i!==null,quick:!/swiftshader|llvmpipe|software|basic render/i.test(e)}}class UI{constructor(t){this.app=t,this.theme(os.getItem("theme")??"");const e=new URLSearchParams(location.hash.slice(1)).get("lang")??"";hd(Object.hasOwn(Nh,e)?e:os.getItem("language")??(navigator.language.startsWith("es")?"es":"en")),C.listen(n=>this.hear(n)),C.say=(n,s="info")=>this.toast(n,s),C.corrected=()=>this.toasts.querySelectorAll(".toast.error").forEach(n=>n.remove()),this.scrub.addEventListener("input",()=>C.send({kind:"Scrub",back:Number(this.scrub.max)-Number(this.scrub.value)})),this.equip(),this.measure("--toasts",this.toasts),this.measure("--fell",this.fell,8),window.addEventListener("keydown",n=>this.key(n)),window.addEventListener("hashchange",()=>C.recorded||this.link()),this.begin()}deeper=null;room=this.furnish();charts=new fA(()=>CI*this.speed);see=new tI;controller=new AR;local=null;robot=Ze?new xR(()=>this.local):new PR;python=new bR;kit=new LR;identify=new DR;keep=new IR(()=>this.picture());tour=new AI({run:t=>(this.greeted(),this.run(t)),knock:t=>(this.sizeTo(t),this.strike()),sizer:()=>this.sizer("act-size").root,tilt:()=>this.tilt(),curves:()=>this.charts.more(),identify:()=>this.bring("Identify")});classes=new yI;newcomer=!os.getItem("toured")&&!Na(location.hash);tab=this.newcomer?"Tour":"Controller";knock=.05;sizers=[];sized=k("span",{className:"of"});speed=1;scrub=k("input",{type:"range",min:"-60",max:"0",step:"0.02",value:"0",className:"scrub","data-key":"scrub"});pauseButton=k("button",{type:"button","data-key":"pause"});status=k("span",{className:"status",role:"status"});light=k("button",{type:"button",className:"headlight","data-key":"headlight",onclick:()=>this.certificate()});force=k("div",{className:"force","aria-hidden":"true"});fell=k("div",{className:"fell",role:"status"});toasts=k("div",{className:"toasts",role:"log","aria-live":"polite"});spoken=k("p",{className:"hidden","aria-live":"off"});tabs=k("div",{className:"tabs",role:"tablist"});panel=k("div",{className:"panel",role:"tabpanel",tabIndex:-1,id:"panel"});clock=k("span",{className:"clock"});state="connecting";drawn=0;down=null;lost=null;best={};most=k("span",{className:"most"});telling=0;waits=0;busy=!1;prepared=!1;begun=!1;timing=!1;drawnFirst=!1;seen=0;plotted=0;said=0;shape="";steering=new aI;pinned=null;begin(){const t=Hd.inPage(),e=zT(location.hash)||(ki.getItem("token")??"");e&&ki.setItem("token",e),location.hash.includes("token=")&&history.replaceState(null,"",location.pathname),this.build(),Ze?(document.body.classList.add("exported"),this.local=new dR(Ze),this.link(),this.says("connected")):t?(this.says("replaying"),new Hd(t),document.body.classList.add("replay")):e&&!ki.getItem("name")&&e.length<12?this.join(e):this.connect(e,ki.getItem("name")??""),requestAnimationFrame(n=>this.frame(n))}connect(t,e){new MR({token:t,name:e},(n,s)=>this.says(n,s))}join(t){const e=k("input",{type:"text",id:"name",maxLength:40,required:!0,autocomplete:"name"}),n=k("dialog",{className:"join","aria-label":U("joinTitle")},k("form",{method:"dialog",onsubmit:s=>{s.preventDefault(),e.value.trim()&&(ki.setItem("name",e.value.trim()),n.remove(),this.connect(t,e.value.trim()))}},k("h2",{},U("joinTitle")),k("label",{for:"name"},U("yourName")),e,k("button",{className:"main"},U("enter"))));this.app.append(n),n.showModal()}build(){const t=k("header",{},k("a",{className:"skip",href:"#panel",onclick:()=>this.panel.focus()},U("skip")),k("h1",{},k("span",{className:"mark","aria-hidden":"true"}),U("title")),k("p",{className:"what"},U("what")),this.light,k("span",{className:"grow"}),this.clock,this.status,Ze?yR(n=>this.toast(n,"info")):null,fs("",TT,Bo(),n=>this.speak(n),"language"),te("◐",()=>this.theme(document.documentElement.dataset.theme==="dark"?"light":"dark"),{"aria-label":U("theme"),title:U("theme"),"data-key":"theme"}),te("?",()=>this.help(),{"aria-label":U("help"),title:U("help"),"data-key":"help"}));t.querySelector("select")?.setAttribute("aria-label","Language / Idioma");const e=k("section",{className:"scene","aria-label":U("scene")},this.room.element,this.force,this.fell,k("p",{className:"hint"},k("span",{},U("hint")),this.invitation()),this.charts.slot,this.pushes(),this.transport());this.pin(e),Xt(this.app,t,k("main",{},e,this.panels(),this.charts.root),this.toasts,this.spoken),this.lamp(),!C.snapshot&&!C.recorded&&this.tell(hn(()=>U("starting"))),C.changed&&this.rebuild()}pin(t){const n={rootMargin:`1000000px 0px ${RI*innerHeight+8*parseFloat(getComputedStyle(document.documentElement).fontSize)-innerHeight}px`},s=new IntersectionObserver(o=>t.classList.toggle("pinned",o.at(-1)?.isIntersecting??!1),n);this.pinned?.disconnect(),this.pinned=s,s.observe(this.tabs)}furnish(){const t=Uh(33,o=>C.push({kind:"Drag",force:o.force,height:o.height})),e=()=>new jD(k("canvas",{className:"room",tabIndex:0,role:"img"}),t),{able:n,quick:s}=II();return n&&(s||!Ze)?e():(this.deeper=n?e:null,new ZD(t))}measure(t,e,n=0){const s=()=>document.documentElement.style.setProperty(t,`${e.childElementCount&&e.offsetHeight+n}px`);new ResizeObserver(s).observe(e)}equip(){this.room.element.setAttribute("aria-label",U("scene")),this.room.element.addEventListener("keydown",t=>this.look(t))}deepen(){const[t,e]=[C.changed,this.room.element];!this.deeper||!t||C.snapshot?.f[0]||(this.room=this.deeper(),this.deeper=null,this.equip(),this.room.furnish(t.look,t.bodies),e.replaceWith(this.room.element),C.snapshot&&this.room.move(C.snapshot),this.room.draw(0))}link(){Na(location.hash)&&this.speed!==1&&this.run(1),gR();const[t,e]=C.last.push??["",0];t==="impulse"&&e>=cc[0]&&e<=cc[1]&&this.sizeTo(e)}run(t,e=!1){this.speed=t;const n=this.app.querySelector("[data-key=speed]");n&&(n.value=String(t)),C.send({kind:"Play",paused:e,speed:t})}transport(){this.pauseButton.onclick=()=>this.pause();const t=[["0.05","× 1/20"],["0.1","× 1/10"],["0.25","× 1/4"],["0.5","× 1/2"],["1","× 1"]],e=fs(U("speed"),t,String(this.speed),a=>this.run(Number(a),C.snapshot?.paused),"speed");e.querySelector("select")?.setAttribute("aria-label",U("speed"));const n=te(U("step"),()=>C.send({kind:"Step",periods:1}),{title:U("stepTip"),"data-key":"step"}),s=U(C.recorded?"timeLine":"back");this.scrub.setAttribute("aria-label",s),C.recorded&&([this.scrub.min,this.scrub.max]=["0",String(C.recorded)]);const o=te(U("standUp"),()=>this.stand(),{"data-key":"stand"});return k("div",{className:"transport"},this.pauseButton,n,o,e,k("label",{className:"scrubbing"},k("span",{},s),this.scrub))}pushes(){const t=(o,a)=>()=>C.push({kind:"Strike",what:o,size:a}),e=()=>C.changed?.look.weight??6,n=this.sizer("knock"),s=te(U("impulse"),()=>this.strike(),{title:U("impulseTip"),className:"main","data-key":"impulse"});return s.append(this.sized),n.root.insertBefore(this.most,n.root.lastChild),this.champion(),k("div",{className:"pushes",role:"group","aria-label":U("pushes")},s,n.root,te(U("front"),t("front",.1),{title:U("frontTip"),"data-key":"front"}),te(U("backPush"),t("back",-.12),{title:U("backTip"),"data-key":"back"}),te(U("pullLeft"),()=>t("pull_left",.25*e())(),{title:U("pullTip"),"data-key":"pull_left"}),te(U("pullRight"),()=>t("pull_right",.25*e())(),{title:U("pullTip"),"data-key":"pull_right"}),te(U("tilt"),()=>this.tilt(),{title:U("tiltTip"),"data-key":"tilt"}))}sizer(t){const[e,n]=cc,s=Kn(U("size"),{low:e,high:n,step:.01,show:o=>`${si(o,2)} N s`,key:t},o=>this.sizeTo(o));return s.root.title=U("sizeTip"),this.sizers=[...this.sizers.filter(({root:o})=>o.isConnected),s],this.sizeTo(this.knock),s}sizeTo(t){this.knock=t;for(const e of this.sizers)e.set(t);this.sized.textContent=` ${si(t,2)} N s`}strike(){C.push({kind:"Strike",what:"impulse",size:this.knock})}tilt(){C.send({kind:"StandUp",pitch:.1})}panels(){const t=Ze?ep:tp.filter(n=>n!=="Python"&&(n!=="Class"||C.role!=="alone")),e={Controller:U("tabController"),Robot:U("tabRobot"),Kit:U("tabKit"),See:U("tabSee"),Identify:U("tabIdentify"),Keep:U("tabKeep"),Tour:U("tabTour"),Class:U("tabClass"),Python:U("tabPython")};return this.tabs.setAttribute("aria-label",U("tabs")),Xt(this.tabs,...t.map(n=>te(e[n],()=>this.bring(n),{role:"tab",id:`tab-${n}`,"aria-selected":String(n===this.tab),"aria-controls":"panel",tabIndex:n===this.tab?0:-1,"data-key":`tab-${n}`,onkeydown:s=>this.along(s,t,n)}))),k("section",{className:"below"},this.tabs,this.panel)}along(t,e,n){const s={ArrowRight:1,ArrowLeft:-1}[t.key];if(!s)return;t.preventDefault(),t.stopPropagation();const o=e[(e.indexOf(n)+s+e.length)%e.length];this.open(o),document.getElementById(`tab-${o}`)?.focus()}invitation(){return this.newcomer?te(U("newHere"),()=>this.bring("Tour"),{"data-key":"invitation"}):null}bring(t){this.open(t),Gs.matches&&this.tabs.scrollIntoView(),document.getElementById(`tab-${t}`)?.scrollIntoView({block:"nearest",inline:"center"})}certificate(){this.open("Controller"),this.panel.querySelector(".light h4")?.scrollIntoView({block:Gs.matches?"start":"center"})}greeted(){this.newcomer=!1,os.setItem("toured","yes"),this.app.querySelector("[data-key=invitation]")?.remove()}open(t){this.tab=t,this.greeted();for(const e of this.tabs.querySelectorAll("[role=tab]")){const n=e.id===`tab-${t}`;e.setAttribute("aria-selected",String(n)),e.tabIndex=n?0:-1}this.panel.setAttribute("aria-labelledby",`tab-${t}`),this.fill()}fill(){if(!C.catalogue||!C.changed)return;const t={Controller:this.controller,Robot:this.robot,Kit:this.kit,See:this.see,Identify:this.identify,Keep:this.keep,Tour:this.tour,Class:this.classes,Python:this.python}[this.tab];Hs(()=>{Ze&&t===this.keep?this.keep.buildExported():t.build(),Xt(this.panel,t.root)})}rebuild(){this.shape="",this.follow(),this.fill(),this.lamp()}follow(){const t=C.changed;if(!t)return;const e=JSON.stringify([t.bodies,t.look]);e!==this.shape&&(this.shape=e,this.room.furnish(t.look,t.bodies),this.charts.build())}hear(t){switch(t.kind){case"Welcome":this.timing=!Ze&&!C.recorded,Hs(()=>this.build());break;case"Catalogue":this.fill();break;case"Changed":{const e=!this.panel.firstChild;this.follow(),!this.begun&&!Ze&&this.link(),this.begun=!0,e?this.fill():this.update(),this.lamp(),this.champion(),this.identify.changed();const n=this.busy&&!t.busy;this.prepared=n&&this.tour.designed(),t.busy!==this.busy&&this.rest();break}case"Analysed":case"Light":this.lamp(),this.update();break;case"Equations":this.tab==="See"&&this.see.show();break;case"Snapshot":this.transported();break;case"Progress":if(t.job==="light"){this.lamp(),this.update();break}this.identify.progress(t.job,t.fraction),t.job==="certify"&&this.controller.certifying(t.fraction);break;case"JobResult":this.identify.found(),t===C.certified&&this.controller.certify(),(t!==C.certified||this.tab!=="Controller")&&this.toast(()=>`${Qe(t.job)} – ${Wi(t.heads).verdict}`,LI[t.heads.en.level]),Us&&this.tab==="Identify"&&Hs(()=>this.identify.build());break;case"Made":if(t.name===Tc){this.compared(C.files+t.url);break}this.keep.made(t.name,t.url.startsWith("blob:")?t.url:C.files+t.url),this.toast(()=>U("made",{name:t.name}),"info");break;case"Notice":t.key==="lies"?this.lie(()=>U("lies")):t.job?this.failed(t):this.toast(()=>t.key?Qe(t.key):Sr(t.parts),t.level);break;case"Recovered":this.recovered(t);break;case"Board":this.tab==="Class"&&this.classes.update();break}}update(){this.tab==="See"&&this.see.show(),{Controller:this.controller,Robot:this.robot,Kit:this.kit,Python:this.python}[this.tab]?.update()}lamp(){const t=cm();if(this.app.classList.toggle("loose",C.falls||(C.changed?.busy??!1)),C.recorded&&(C.lit?.light??"none")==="none")return Xt(this.light);this.light.title=`${Dh(Ec())}. ${U("lightNote")}`,Xt(this.light,k("span",{className:`lamp ${t}`,"aria-hidden":"true"}),k("span",{className:"word","aria-hidden":"true"},t==="none"?"…":U(t)),k("span",{},`${U("certificate")}:`),k("span",{},Ec(!0)))}recovered({impulse:t,fell:e,single:n}){const s=this.driven(),o=this.best[s]??0,a=Math.max(o,n&&!e?t:0);this.prepared=!1,a&&(this.best[s]=a),this.champion();const r=()=>({impulse:_e(t),best:_e(a)});if(e&&(this.lost=()=>U(n?"lostPush":"lostPushes",r())),this.down)return this.lie();e||(this.tell(hn(()=>U(n?a<o*(1+PI)?"recovered":"recoveredMost":"recoveredSeveral",r()))),this.telling=window.setTimeout(()=>this.rest(),6e3))}compared(t){this.identify.compared(t),this.tab!=="Identify"&&this.toast(()=>U("comparedThere"),"info")}failed({job:t,parts:e,level:n}){const s=t.startsWith("keep compar")?"compare":t,o=["doctor","calibrate","compare"].includes(s),a=()=>o||t==="certify"?U("jobStopped",{job:Qe(s),why:Sr(e)}):Sr(e),r=()=>e.en?a():U("wasStopped",{job:Qe(s)});o&&e.en&&this.identify.fail(r,e.en.verb),(!o||!e.en||this.tab!=="Identify")&&this.toast(r,n)}driven(){return`${C.setup.robot} ${C.setup.controller}`}champion(){const t=this.best[this.driven()];this.most.textContent=t?U("best",{best:_e(t)}):"",this.most.title=U("bestTip")}tell(...t){window.clearTimeout(this.telling),Xt(this.fell,...t)}rest(){if(this.busy=C.changed?.busy??!1,this.down)return;const t=()=>[U("designing"),C.setup.controller==="robust"?U("robustTakes"):""].join(" ").trim();this.tell((this.busy||this.prepared)&&hn(()=>this.busy?t():U("designed")))}lie(t=this.lost??(()=>U("fallen"))){const e=k("button",{type:"button",className:"main",onclick:()=>this.stand()},hn(()=>U("standUp")));this.tell(hn(t),!C.recorded&&e)}transported(){const t=C.snapshot;if(!t)return;this.timing&&C.send({kind:"Play",paused:t.paused,speed:this.speed}),this.timing=!1;const e=t.paused?U("play"):U("pause");this.pauseButton.textContent!==e&&(this.pauseButton.textContent=e),C.recorded?this.timed(t.t):document.activeElement!==this.scrub&&(this.scrub.min=String(-Math.min(Math.max(Math.ceil(t.t+t.back-(C.traces.t[0]??t.t)),1),60)),this.scrub.value=String(-t.back)),this.clock.textContent=`${si(t.t,1)} ${C.recorded?`/ ${si(C.recorded,1)} `:""}s`;const n=!!t.x[0][8];n!==this.down&&(n||(this.lost=null),this.down=n,n?this.lie():this.rest(),this.app.querySelector("[data-key=impulse]")?.classList.toggle("main",!n));const s=t.f[0],o=t.f[2]?`${U("slope")}: ${Ih(t.f[2])}`:"";C.traces.marks.some(({what:a})=>!yc.includes(a))&&this.app.classList.add("pushed"),this.force.textContent=Math.abs(s)>.005?U("newtons",{force:si(s,2)}):o,this.force.classList.toggle("slope",!(Math.abs(s)>.005))}timed(t){this.scrub.matches(":active")||(this.scrub.value=String(t)),this.scrub.setAttribute("aria-valuetext",`${si(t,1)} s`)}seek(t){const[e,n]=[C.snapshot,C.recorded||60],s=(C.recorded?C.recorded-(e?.t??0):e?.back??0)-t;C.send({kind:"Scrub",back:Math.max(0,Math.min(n,s))})}stand(){C.send({kind:"StandUp",pitch:C.falls?tl:0}),C.send({kind:"Play",paused:!1,speed:this.speed})}pause(){C.send({kind:"Play",paused:!C.snapshot?.paused,speed:this.speed})}says(t,e=()=>""){t==="lost"&&this.state!=="lost"&&(this.waits=window.setTimeout(()=>this.tell(hn(()=>U("gone"))),NI)),t==="connected"&&this.state==="lost"&&this.back(),this.state=t;const n={connecting:U("connecting"),connected:U("connected"),lost:U("lost"),refused:U("refused"),replaying:U("replaying")};this.status.className=`status ${t}`,this.status.textContent=n[t],t==="refused"&&(ki.removeItem("name"),Xt(this.app,k("main",{className:"refused",role:"alert"},k("h1",{},U("refused")),k("p",{},e()),te("↻",()=>location.reload()))))}back(){window.clearTimeout(this.waits),this.down?this.lie():this.rest()}toast(t,e){if(this.toasts.lastElementChild?.firstElementChild?.textContent===t())return;const n=k("button",{type:"button",onclick:()=>s.remove()},k("span",{"aria-hidden":"true"},"×"),k("span",{className:"hidden"},hn(()=>U("close")))),s=k("div",{className:`toast ${e}`},hn(t),n);this.toasts.querySelectorAll(e==="error"?".toast.error":".toast:not(.error)").forEach(o=>o.remove()),this.toasts.append(s),window.setTimeout(()=>s.remove(),e==="error"?15e3:6e3)}speak(t){hd(t),os.setItem("language",t),this.build(),this.says(this.state),La(this.app),this.describe(),this.app.querySelector("[data-key=language]")?.focus()}theme(t){const e=t?t==="dark":matchMedia("(prefers-color-scheme: dark)").matches;document.documentElement.dataset.theme=e?"dark":"light",t&&os.setItem("theme",t),this.room.paint(),C.changed&&this.charts.build(),this.panel.firstChild&&this.fill()}help(){const t=["impulse","size","front","back","pull","tilt","step"].map(h=>[U(h==="pull"?"pullBoth":h==="back"?"backPush":h),U(`${h}Tip`)]),[e,n,s,...o]=Ja().keys,r=(matchMedia("(hover: none)").matches?[s,...t]:[...t,e,n,s,...o]).map(([h,u])=>k("tr",{},k("th",{scope:"row"},h),k("td",{},u))),l=k("h2",{tabIndex:-1},U("help")),c=k("dialog",{className:"help","aria-label":U("help"),onclose:()=>c.remove()},l,k("table",{},k("tbody",{},...r)),k("div",{className:"foot"},te(U("close"),()=>c.close(),{className:"main"})));this.app.append(c),c.showModal(),l.focus(),c.scrollTop=0}key(t){if(!(bc(t,"input, select, textarea, dialog")||t.key===" "&&bc(t,"button, summary"))){if(t.key==="?")this.help();else if(t.key===" ")this.pause();else if(t.key===".")C.send({kind:"Step",periods:1});else if(t.key===","||t.key==="/")this.seek(t.key===","?-.25:.25);else if(t.key==="s")this.stand();else if(t.key==="n"||t.key==="p")this.toured(t.key==="n"?1:-1);else if(t.key==="k")this.strike();else if(/^[1-8]$/.test(t.key)&&document.getElementById(`tab-${this.tabAt(t.key)}`))this.open(this.tabAt(t.key));else return;t.preventDefault()}}tabAt(t){return(Ze?ep:tp)[Number(t)-1]}toured(t){const e=this.tab==="Tour";e||this.open("Tour"),this.tour.move(e?t:0)}look(t){const e={"[":[-.15,0],"]":[.15,0],"{":[0,-.1],"}":[0,.1]};t.key in e&&this.room.turn(...e[t.key]),t.key==="+"&&this.room.zoom(.9),t.key==="-"&&this.room.zoom(1.1)}frame(t){C.snapshot&&this.room.move(C.snapshot),this.room.draw(t-this.drawn),this.drawnFirst&&t>this.seen+DI?this.deepen():C.snapshot&&!this.drawnFirst&&([this.drawnFirst,this.seen]=[!0,t]),this.drawn=t,t-this.plotted>45&&(this.charts.draw(),this.tab==="See"&&this.see.draw(),this.plotted=t),t-this.said>2e3&&(this.describe(),this.said=t),this.steering.tick(t),requestAnimationFrame(e=>this.frame(e))}describe(){const[t,e]=[C.snapshot,C.changed];if(!t||!e)return;const n=Qe(e.bodies[0]),s=si(e.look.wheel_radius*t.x[0][2]*100,0),o=t.x[0][8]?U("fellNow",{body:n}):U("sceneNow",{body:n,pitch:si(t.x[0][0]*180/Math.PI,1),way:s});this.spoken.textContent=o,this.room.element.setAttribute("aria-label",`${U("scene")} ${o}`)}picture(){return this.room.picture([C.setup.robot,Qe(C.setup.controller),`${si(C.snapshot?.t??0,1)} s`,"upright lab"].join("  ·  "))}address(){return zh()}grasp(){return this.room.grasp()}}const kI=new UI(document.getElementById("app"));Object.assign(window,{upright:{store:C,page:kI,exported:Ze}});
